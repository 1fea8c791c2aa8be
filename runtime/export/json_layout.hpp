// How JSON files are laid out for readers and for diffs.
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Breaks compact, valid JSON into lines: what fits on a line of about 100 columns stays on one, longer objects and
/// arrays take a line a member, long arrays of plain numbers are filled. Ends with a new line; the content is
/// untouched.
std::string laid_out(std::string_view compact);

}  // namespace toile
