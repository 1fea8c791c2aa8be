// Lines that follow each other set in columns: names before `=`, words that begin statements, comments at their ends.
#pragma once

#include <string>
#include <vector>

#include "grammar/format/document.hpp"

namespace toile::syntax {

/// The text of the lines.
std::string set_in_columns(std::vector<TextLine> lines);

}  // namespace toile::syntax
