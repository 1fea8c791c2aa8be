// What is marked on a piece beside its outline: fold, darts, pleats, notches, lines, drill holes, buttons.
#pragma once

#include <string>

#include "compiler/pattern/pattern.hpp"

namespace toile {

/// As SVG, in the piece's own coordinates.
std::string marks_svg(const Piece& piece);
/// The rules for the classes that it uses.
std::string marks_style();

}  // namespace toile
