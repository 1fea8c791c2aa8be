// Rings of a body: polygons on superellipses with a given perimeter.
#pragma once

#include <vector>

#include "runtime/mesh/vec3.hpp"

namespace toile {

/// A closed polygon in the plane z = 0 of `count` (a multiple of four) vertices on |x/a|^n + |y/b|^n = 1, a/b =
/// `ratio`, evenly spaced by arc length in each quadrant and scaled so that the polygon's perimeter is `girth`. It
/// starts at (0, -b), the front, and runs counter-clockwise through (a, 0); symmetric in both axes.
std::vector<Vec3> superellipse(int count, double girth, double ratio, double n);

}  // namespace toile
