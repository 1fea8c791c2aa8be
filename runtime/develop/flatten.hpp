// The plane pattern that takes a surface in space with the least energy: min E_au + E_av + E_sh over the plane
// coordinates (paper, section 5).
#pragma once

#include <array>
#include <vector>

#include "compiler/curve/vec2.hpp"
#include "runtime/develop/length_match.hpp"
#include "runtime/energy/membrane.hpp"
#include "runtime/fabric/law.hpp"
#include "runtime/mesh/vec3.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

struct FlatteningInput {
  std::vector<std::array<int, 3>> triangles;  // into the points, counter-clockwise at the start
  std::vector<Vec3> target;                   // of each point, in space
  std::vector<Vec2> start;                    // (warp, weft) of each point; no triangle is flipped
  std::vector<LengthMatch> matches;
  /// Of every piece two points that lie along the warp from each other: the first stays, and the second goes neither
  /// way across the warp. That takes away the rigid motions and holds the grain.
  struct GrainLine {
    int from = 0, to = 0;
  };
  std::vector<GrainLine> grain;
};

/// The two points of an outline that lie most nearly along the warp and far apart, of those equally straight the ones
/// in the middle of the piece.
FlatteningInput::GrainLine grain_line(const std::vector<Vec2>& start, const std::vector<int>& outline);

struct Flattened {
  std::vector<Vec2> uv;
  std::vector<MembraneStrain> strains;  // of each triangle
  MembraneEnergy energy;
  double area = 0, target_area = 0;
  double mismatch = 0;  // [m] the largest difference of the lengths of two sides of a seam
  int flipped = 0;      // triangles without positive area: none, ever
  bool converged = false, cancelled = false;
  int iterations = 0, factorisations = 0;
  double residual_N = 0;         // the largest derivative of the energy by the place of a point
  double residual_relative = 0;  // that over the force of a strain of one on a mean edge
};

struct FlattenOptions {
  double tolerance = 1e-7;         // of the relative residual
  double length_tolerance = 5e-5;  // [m] of the two sides of a seam
  int max_iterations = 300;
};

/// Always returns finite places with no triangle flipped.
Flattened flatten(const FlatteningInput& input, const FabricLaw& law, const FlattenOptions& options, const Job& job);

/// What stands in the result but how the solver fared, for a pattern at hand.
Flattened measured(const FlatteningInput& input, const FabricLaw& law, std::vector<Vec2> uv);

}  // namespace toile
