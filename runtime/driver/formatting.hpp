// `toile fmt`: scripts set in the one layout, in place.
#pragma once

#include <string>
#include <vector>

#include "runtime/driver/listener.hpp"
#include "runtime/driver/outcome.hpp"

namespace toile {

/// Rewrites the files that are not in the layout, whole or not at all; the name `-` stands for standard input, laid out
/// on standard output. With `check` nothing is written and the files that are not in the layout are told. A text with
/// syntax errors is left as it is and its errors are told.
Outcome format_files(const std::vector<std::string>& files, bool check, Listener& listener);

}  // namespace toile
