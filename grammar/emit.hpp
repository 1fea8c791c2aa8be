// The tree as text for people and golden files.
#pragma once

#include <string>

#include "grammar/source.hpp"
#include "grammar/tree.hpp"

namespace toile::syntax {

/// One line a node, indented by two blanks a level, without trivia: "Let", "'let'", "Name w", "Digits 60". Bytes that
/// are not printable ASCII or UTF-8 text are written as \xNN.
std::string emit(const Tree& tree, const Source& source);

}  // namespace toile::syntax
