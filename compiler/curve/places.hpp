// Places on curves that drafting asks for: where two meet, where a point's perpendicular falls, where a line touches.
// Exact for lines and arcs; for Béziers the roots of their polynomials, to rounding.
#pragma once

#include <vector>

#include "compiler/curve/curve.hpp"

namespace toile {

/// All places where two curves meet, their ends included, in the order of the first. Curves that run along each other
/// meet at the ends of what they share; Béziers that do are given by up to 32 places.
std::vector<Crossing> intersections(const Curve& first, const Curve& second);

/// Arc lengths [m], ascending, at which the curve runs square to the way from `point`: the feet of its perpendiculars.
/// None at a corner, and none on an arc about the point itself.
std::vector<double> perpendicular_feet(const Curve& curve, Vec2 point);

/// The arc length [m] of the place nearest to `point`; the first one where there are several.
double nearest_place(const Curve& curve, Vec2 point);

/// Arc lengths [m], ascending, at which a line from `point` touches the curve.
std::vector<double> tangent_places(const Curve& curve, Vec2 point);

}  // namespace toile
