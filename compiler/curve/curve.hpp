// Plane curves of a pattern: chains of lines, circular arcs and cubic Béziers, kept exact until a mesh asks for points.
#pragma once

#include <variant>
#include <vector>

#include "compiler/curve/vec2.hpp"

namespace toile {

struct LineSegment {
  Vec2 from, to;
};

/// The part of a circle from `start` [rad] through `sweep` [rad]; a positive sweep turns to the left.
struct ArcSegment {
  Vec2 centre;
  double radius = 0;
  double start = 0;
  double sweep = 0;
};

struct BezierSegment {
  Vec2 p0, p1, p2, p3;
};

using Segment = std::variant<LineSegment, ArcSegment, BezierSegment>;

/// One edge of a piece: segments that join end to start. Parametrised by arc length from 0 to `length()`.
/// Lengths of lines and arcs are exact; those of Béziers come from adaptive Gauss-Legendre quadrature with an error
/// below 1e-12 m.
class Curve {
 public:
  Curve() = default;
  explicit Curve(std::vector<Segment> segments);

  const std::vector<Segment>& segments() const { return segments_; }
  bool empty() const { return segments_.empty(); }
  double length() const;
  /// The arc length [m] at which the i-th segment starts.
  double start_of(std::size_t segment) const { return segment == 0 ? 0 : ends_[segment - 1]; }
  Vec2 start() const;
  Vec2 end() const;
  /// The point after the arc length `s` [m], clamped to the curve.
  Vec2 at(double s) const;
  /// The unit tangent there, in the direction of travel.
  Vec2 tangent(double s) const;
  /// 1 / radius there [1/m], positive where the curve turns to the left.
  double curvature(double s) const;
  Curve reversed() const;
  /// The part between two arc lengths, s0 < s1.
  Curve part(double s0, double s1) const;
  /// Reflected in the line through `point` along the unit vector `axis`; direction of travel is kept.
  Curve mirrored(Vec2 point, Vec2 axis) const;
  Curve moved(Vec2 shift) const;
  Curve rotated(double angle, Vec2 about) const;
  /// Arc lengths 0 = s0 < s1 < … = length() such that the chords between them stray from the curve by at most
  /// `chord_error` [m] and no two lie further apart than `longest` [m].
  std::vector<double> divide(double chord_error, double longest) const;
  /// Points from the start to the end whose chords stray from the curve by at most `chord_error` [m]; no lengths are
  /// asked for, so this costs little.
  std::vector<Vec2> polygon(double chord_error) const;

 private:
  std::vector<Segment> segments_;
  std::vector<double> ends_;  // arc length at the end of each segment
};

Curve line(Vec2 from, Vec2 to);
Curve arc_through(Vec2 from, Vec2 through, Vec2 to);
/// The shorter arc of that radius (the longer with `large`); turns left for radius > 0, right for radius < 0.
Curve arc_of_radius(Vec2 from, Vec2 to, double radius, bool large = false);
Curve circle(Vec2 centre, Vec2 from, bool left = true);
Curve bezier(Vec2 p0, Vec2 p1, Vec2 p2, Vec2 p3);
/// A cubic from `from` to `to` with the given directions of travel at its ends [rad]; control arms are a third of the
/// chord, lengthened so that a circular arc is met to third order.
Curve tangent_curve(Vec2 from, double leaving, Vec2 to, double arriving);
Curve join(const std::vector<Curve>& curves);

/// Where two curves, or a curve and itself, meet other than at a shared end: the arc lengths on each.
struct Crossing {
  double s_first = 0;
  double s_second = 0;
  Vec2 point;
};
std::vector<Crossing> crossings(const Curve& first, const Curve& second);
std::vector<Crossing> self_crossings(const Curve& curve);
/// The same with shared ends, too: by halving, for any two curves.
std::vector<Crossing> meetings(const Curve& first, const Curve& second);

}  // namespace toile
