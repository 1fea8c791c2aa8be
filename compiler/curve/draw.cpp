// Ways to draw a curve.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/curve/segment.hpp"
#include "compiler/curve/shape.hpp"

namespace toile {
namespace {

using std::numbers::pi;

double angle_of(Vec2 v) {
  return std::atan2(v.y, v.x);
}

// The angle brought to (-pi, pi].
double wrapped(double angle) {
  const double turns = std::remainder(angle, 2 * pi);
  return turns <= -pi ? turns + 2 * pi : turns;
}

}  // namespace

Curve line(Vec2 from, Vec2 to) {
  return Curve({LineSegment{from, to}});
}

Curve arc_through(Vec2 from, Vec2 through, Vec2 to) {
  const Vec2 a = through - from, b = to - from;
  const double area = cross(a, b);
  if (std::abs(area) <= 1e-12 * norm(a) * norm(b)) return line(from, to);
  const Vec2 centre = from + (dot(a, a) * -perpendicular(b) + dot(b, b) * perpendicular(a)) / (2 * area);
  const double radius = distance(centre, from);
  const double begin = angle_of(from - centre);
  double sweep = wrapped(angle_of(to - centre) - begin);
  // from, through, to turn to the left exactly when the arc does.
  if (area > 0 && sweep < 0) sweep += 2 * pi;
  if (area < 0 && sweep > 0) sweep -= 2 * pi;
  return Curve({ArcSegment{centre, radius, begin, sweep}});
}

Curve arc_of_radius(Vec2 from, Vec2 to, double radius, bool large) {
  const double chord = distance(from, to);
  if (!(chord > 0)) return line(from, to);
  const double r = std::max(std::abs(radius), chord / 2);
  const double turn = radius < 0 ? -1 : 1;
  const double height = std::sqrt(std::max(0.0, r * r - chord * chord / 4));
  const Vec2 left = perpendicular(to - from) / chord;
  const Vec2 centre = 0.5 * (from + to) + (large ? -turn : turn) * height * left;
  const double shorter = 2 * std::asin(std::min(1.0, chord / (2 * r)));
  const double sweep = turn * (large ? 2 * pi - shorter : shorter);
  return Curve({ArcSegment{centre, r, angle_of(from - centre), sweep}});
}

Curve circle(Vec2 centre, Vec2 from, bool left) {
  return Curve({ArcSegment{centre, distance(centre, from), angle_of(from - centre), left ? 2 * pi : -2 * pi}});
}

Curve bezier(Vec2 p0, Vec2 p1, Vec2 p2, Vec2 p3) {
  return Curve({BezierSegment{p0, p1, p2, p3}});
}

Curve tangent_curve(Vec2 from, double leaving, Vec2 to, double arriving) {
  const double chord = distance(from, to);
  const double along = angle_of(to - from);
  // An arc that leaves its chord at the angle a turns through 2a; its best cubic has arms 4/3 tan(a/2) r, which is
  // chord / (3 cos^2(a/2)). Beyond 120 degrees the arms would run away.
  const auto arm = [&](double angle) {
    const double cosine = std::cos(std::min(std::abs(wrapped(angle)), 2 * pi / 3) / 2);
    return chord / (3 * cosine * cosine);
  };
  return bezier(from, from + arm(leaving - along) * direction(leaving),
                to - arm(arriving - along) * direction(arriving), to);
}

Curve arc_about(Vec2 centre, double radius, double from, double to) {
  return Curve({ArcSegment{centre, radius, from, to - from}});
}

Curve extended(const Curve& curve, double before, double after) {
  std::vector<Segment> segments = curve.segments();
  if (segments.empty()) return curve;
  const auto straight_on = [](Vec2 from, Vec2 tangent, double length) {
    return LineSegment{from, from + length * tangent};
  };
  if (before > 0) {
    Segment& first = segments.front();
    if (auto* line = std::get_if<LineSegment>(&first)) {
      line->from = line->from - before * unit_tangent(first, 0);
    } else if (auto* arc = std::get_if<ArcSegment>(&first)) {
      const double turn = std::copysign(before / arc->radius, arc->sweep);
      arc->start -= turn;
      arc->sweep += turn;
    } else {
      const Segment lead = reversed(Segment{straight_on(point(first, 0), -unit_tangent(first, 0), before)});
      segments.insert(segments.begin(), lead);
    }
  }
  if (after > 0) {
    Segment& last = segments.back();
    if (auto* line = std::get_if<LineSegment>(&last)) {
      line->to = line->to + after * unit_tangent(last, 1);
    } else if (auto* arc = std::get_if<ArcSegment>(&last)) {
      arc->sweep += std::copysign(after / arc->radius, arc->sweep);
    } else {
      segments.emplace_back(straight_on(point(last, 1), unit_tangent(last, 1), after));
    }
  }
  return Curve(std::move(segments));
}

Curve join(const std::vector<Curve>& curves) {
  std::vector<Segment> segments;
  for (const Curve& curve : curves) segments.insert(segments.end(), curve.segments().begin(), curve.segments().end());
  return Curve(std::move(segments));
}

}  // namespace toile
