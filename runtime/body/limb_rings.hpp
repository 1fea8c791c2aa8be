// Rings across a limb.
#pragma once

#include <vector>

#include "runtime/body/half_form.hpp"

namespace toile {

/// A frame across a limb of the left half: `along` its axis, `up` towards the shoulder or, on a leg, outwards; the
/// front is -y.
struct LimbFrame {
  Vec3 centre;
  Vec3 along;
  Vec3 up() const;
};

/// A polygon of `count` (a multiple of four) vertices, an ellipse `ratio` times as long along `up` as from front to
/// back, of perimeter `girth`. From the front counter-clockwise seen from the root.
std::vector<Vec3> limb_ring(const LimbFrame& frame, int count, double girth, double ratio);

/// Rings that morph from one loop to another, free for fairing; returns the last, and joins all to `upper` and `lower`.
void blend_loops(const std::vector<int>& upper, const std::vector<int>& lower, int between, HalfForm& form);

/// Closes the tip below its last ring by a dome.
void cap_limb(const std::vector<int>& rim, const LimbFrame& frame, HalfForm& form);

}  // namespace toile
