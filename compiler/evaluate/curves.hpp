// Curves as scripts draw them: inputs that give no curve are mistakes to be told, not numbers to be lost.
#pragma once

#include <optional>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// From `from` to `to` with directions of travel [rad] where they are given: with one alone the curve bends like a
/// circular arc, with none it is a straight line.
Curve drawn_curve(Vec2 from, Vec2 to, std::optional<double> leaving, std::optional<double> arriving);

/// Nothing, with an error at `at`, when the three points lie on a line (no circle passes through them).
std::optional<Curve> drawn_arc(Session& session, Vec2 from, Vec2 to, Vec2 through, Location at);

/// Nothing, with an error, when the radius [m] is too small to span the two points.
std::optional<Curve> drawn_arc(Session& session, Vec2 from, Vec2 to, double radius, bool large, Location at);

/// Through the points in turn. Nothing, with an error, when there are too few or two in turn are the same.
std::optional<Curve> drawn_spline(Session& session, const std::vector<Vec2>& points, std::optional<double> leaving,
                                  std::optional<double> arriving, bool closed, Location at);

/// The curve between the same ends, but of that length [m]. Nothing, with an error, when that cannot be.
std::optional<Curve> lengthened(Session& session, const Curve& curve, double length, Location at);

/// The one place where two curves meet. Nothing, with an error at `at`, where the second is written, when there is none
/// or more than one.
std::optional<Crossing> only_crossing(Session& session, const Curve& first, const Curve& second, Location at);

/// Where on the curve [m]: a length as it is, a plain number as a fraction of the whole, a point of the curve, or
/// another curve that crosses it. Nothing, with an error, where that is no place on it. `whose` names the curve for the
/// message.
std::optional<double> arc_length_at(Session& session, const Curve& curve, const Value& where, Location at,
                                    const std::string& whose);

}  // namespace toile
