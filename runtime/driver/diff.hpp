// What differs between two texts, line by line, for a person to read.
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Lines that only `expected` has start with "-", those that only `found` has with "+", with up to three lines of
/// context; "@@ N @@" gives the line in `expected`. Empty when the texts are equal. Long differences are cut short.
std::string line_diff(std::string_view expected, std::string_view found);

}  // namespace toile
