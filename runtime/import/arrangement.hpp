// Where a foreign pattern puts its panels, in the words of the language.
#pragma once

#include <array>

#include "runtime/import/foreign_pattern.hpp"

namespace toile {

/// As `arrange` has it: the drawing's origin [m], x to the wearer's left, y to the back, z up, and the turns [deg]
/// about these axes, one after the other, from standing upright and facing the front.
struct ScriptPlace {
  std::array<double, 3> at{}, turn{};
};

/// `is_mirrored`: the script draws the panel with its x the other way.
ScriptPlace script_place(const ForeignPlacement& placement, bool is_mirrored);

}  // namespace toile
