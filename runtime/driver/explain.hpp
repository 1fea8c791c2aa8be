// `toile explain`: what a diagnostic means.
#pragma once

#include <string>

#include "runtime/driver/listener.hpp"
#include "runtime/driver/outcome.hpp"

namespace toile {

/// Prints the page of a code, in whatever case it is written, or without one a line a code. An unknown code is wrong
/// usage, and the nearest known one is suggested.
Outcome explain(const std::string& code, Listener& listener);

}  // namespace toile
