// `toile import`: patterns of other programs as scripts.
#pragma once

#include <string>

#include "runtime/driver/listener.hpp"
#include "runtime/driver/outcome.hpp"

namespace toile {

/// Reads a pattern specification of GarmentCode and writes it to `output` as a script in the one layout. A file that is
/// none is told as an input file's failure, with its panel and edge, and nothing is written.
Outcome import_pattern(const std::string& input, const std::string& output, Listener& listener);

}  // namespace toile
