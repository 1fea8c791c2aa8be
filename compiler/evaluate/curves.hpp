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

/// Where on the curve: a length as it is, a plain number as a fraction of the whole. Nothing, with an error, beyond its
/// ends. `whose` names the curve for the message.
std::optional<double> arc_length_at(Session& session, const Curve& curve, const Value& where, Location at,
                                    const std::string& whose);

}  // namespace toile
