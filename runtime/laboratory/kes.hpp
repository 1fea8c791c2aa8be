// The virtual KES laboratory: the tensile, shear and pure bending tests of the Kawabata Evaluation System on meshed
// specimens of a cloth, with the loops of its inner friction (Kawabata, The Standardization and Analysis of Hand
// Evaluation, 2nd ed., 1980).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "compiler/curve/vec2.hpp"
#include "compiler/pattern/fabric_sheet.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

/// Deformation and force at each step of a test, SI.
using KesCurve = std::vector<Vec2>;

struct KesReading {
  FabricSheet sheet;                // LT, WT, EMT, G, 2HG, 2HG5, B and 2HB as read off the curves
  std::array<KesCurve, 2> tensile;  // of warp and weft: strain [1], force per width [N/m]
  std::array<KesCurve, 2> shear;    // angle [rad], force per width [N/m]
  std::array<KesCurve, 2> bending;  // curvature [1/m], moment per width [N]
  std::string trouble;              // what did not come to rest; empty when all did
};

KesReading kes_reading(const FabricSheet& fabric, const Job& job);

}  // namespace toile
