// A foreign pattern written as a script.
#pragma once

#include <string>
#include <vector>

#include "runtime/import/foreign_pattern.hpp"

namespace toile {

struct ImportedScript {
  std::string text;
  std::vector<std::string> notes;  // a line on each seam whose lengths differ without a likely reason
};

/// One garment: a piece a panel, seen from its right side, each edge with a name; seams with the fullness that the
/// lengths of their edges ask for. `source` is the file's name for the comment at the beginning, and the garment's.
/// The text is not in the layout of `toile fmt`.
ImportedScript script_text(const ForeignPattern& pattern, const std::string& source);

}  // namespace toile
