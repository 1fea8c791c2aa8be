// Curves made from points and from other curves.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "compiler/curve/curve.hpp"

namespace toile {

/// The smoothest cubic curve through the points in turn: its direction and (in the chord's measure) its curvature run
/// on at each of them. At the ends it has the directions [rad] that are given, and else no curvature. Two points or
/// more, no two alike in turn.
Curve spline(const std::vector<Vec2>& points, std::optional<double> leaving = {}, std::optional<double> arriving = {});
/// The same through three points or more and back to the first.
Curve closed_spline(const std::vector<Vec2>& points);

/// The arc of a circle about a point, from one direction [rad] to another; it turns left where `to` is the larger.
Curve arc_about(Vec2 centre, double radius, double from, double to);

/// The curve prolonged by lengths [m] at its start and its end: arcs on their circles, all else straight on.
Curve extended(const Curve& curve, double before, double after);

/// The curve at `distance` [m] to its left (to the right when negative): all its points lie at that distance from the
/// nearest place of the curve. Corners are rounded on the outside; what would fold on the inside is cut off. Lines and
/// arcs stay what they are, Béziers are met within a micrometre. Nothing when all of it is cut off, or when what is
/// left is not one curve.
std::optional<Curve> offset(const Curve& curve, double distance);

/// The corner where the second curve goes on from the first, rounded by an arc of that radius [m] which touches both:
/// what is left of the first, the arc, what is left of the second. Nothing where no such arc fits, or where there is no
/// corner.
std::optional<std::array<Curve, 3>> fillet(const Curve& first, const Curve& second, double radius);

/// The curve with the same ends, but of that length [m]. A Bézier keeps the directions at its ends, an arc becomes one
/// of another radius, a closed curve is scaled about its start; any other chain is stretched across the line between
/// its ends. Nothing when that cannot be: the length is not more than the distance of the ends, the curve is straight,
/// or it would cross itself.
std::optional<Curve> of_length(const Curve& curve, double length);

}  // namespace toile
