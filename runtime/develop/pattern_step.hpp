// How a pattern must change for its draped cloth to come nearer to the form: one Gauss-Newton step by the sensitivity
// of the equilibrium. With G(x, u) = 0 the balance of forces at rest, dx = -H^-1 (dG/du) du, H the drape's true
// Hessian.
#pragma once

#include <vector>

#include "runtime/develop/flatten.hpp"
#include "runtime/develop/form_distance.hpp"
#include "runtime/drape/rest_state.hpp"
#include "runtime/mesh/cloth.hpp"

namespace toile {

/// [m] The root of the mean square of what a draped cloth misses its form by: each vertex the form's surface by the
/// whole of its distance, and its own place there by a share of what it lies aside, lest less cloth be nearer.
double missed(const Cloth& cloth, const FormDistance& misses);

struct PatternStep {
  std::vector<Vec2> change;  // [m] of each point of the pattern, (warp, weft); empty where none was found
  double left = 1;           // the share of the misses that would be left if all were linear
};

/// The change of the pattern `uv` that takes most off the misses, weighed against the strain of the change itself by
/// `caution`; seams stay matched and grain lines where they are. `cloth` is what was draped: triangle for triangle that
/// of `plane`.
PatternStep pattern_step(const FlatteningInput& plane, const std::vector<Vec2>& uv, const Cloth& cloth,
                         const RestState& rest, const FormDistance& misses, double caution);

/// The pattern moved by so much of a change that no triangle loses half of its area, its seams made to match again.
std::vector<Vec2> changed_pattern(const FlatteningInput& plane, const std::vector<Vec2>& uv,
                                  const std::vector<Vec2>& change);

}  // namespace toile
