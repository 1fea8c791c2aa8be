// "This curve, but 23.4cm long": each kind of curve has one way to grow, along which its length only grows.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "compiler/curve/shape.hpp"
#include "compiler/solve/root.hpp"

namespace toile {
namespace {

using std::numbers::pi;

constexpr double touching_ends = 1e-9;  // [m]
constexpr double most_growth = 64;      // times as bent as drawn: nothing that anyone means

/// The member of a family of curves that has the length; the family's length rises with its number.
std::optional<Curve> member_of_length(const std::function<Curve(double)>& family, double least, double most,
                                      double length) {
  const auto excess = [&](double k) { return std::optional(family(k).length() - length); };
  const double at_least = *excess(least), at_most = *excess(most);
  if (!(at_least < 0 && at_most > 0)) return std::nullopt;
  Curve found = family(root_within(excess, {least, most, at_least, at_most}).value_or(least));
  if (!self_crossings(found).empty()) return std::nullopt;
  return found;
}

std::optional<Curve> longer_arc(const ArcSegment& arc, double length) {
  const Vec2 from = arc.centre + arc.radius * direction(arc.start);
  const Vec2 to = arc.centre + arc.radius * direction(arc.start + arc.sweep);
  const double turn = arc.sweep < 0 ? -1 : 1;
  const auto family = [&](double half) {  // half of what the arc sweeps
    const double radius = distance(from, to) / (2 * std::sin(half));
    return arc_of_radius(from, to, turn * radius, half > pi / 2);
  };
  return member_of_length(family, 1e-6, pi - 1e-6, length);
}

std::optional<Curve> longer_arms(const BezierSegment& b, double length) {
  const auto family = [&](double k) { return bezier(b.p0, b.p0 + k * (b.p1 - b.p0), b.p3 + k * (b.p2 - b.p3), b.p3); };
  return member_of_length(family, 0, most_growth, length);
}

Curve placed_anew(const Curve& curve, double k, const std::function<Vec2(Vec2, double)>& place) {
  std::vector<Segment> segments;
  const auto add = [&](const BezierSegment& b) {
    segments.emplace_back(BezierSegment{place(b.p0, k), place(b.p1, k), place(b.p2, k), place(b.p3, k)});
  };
  for (const Segment& segment : curve.segments()) {
    if (const auto* line = std::get_if<LineSegment>(&segment)) {
      segments.emplace_back(LineSegment{place(line->from, k), place(line->to, k)});
    } else if (const auto* b = std::get_if<BezierSegment>(&segment)) {
      add(*b);
    } else {
      // A stretched arc is no arc; cubics over an eighth of a right angle meet one to a part in 10^9.
      const auto& arc = std::get<ArcSegment>(segment);
      const int parts = static_cast<int>(std::ceil(std::abs(arc.sweep) / (pi / 16)));
      const double step = arc.sweep / parts, arm = 4.0 / 3 * std::tan(step / 4) * arc.radius;
      for (int i = 0; i < parts; ++i) {
        const Vec2 a = direction(arc.start + i * step), c = direction(arc.start + (i + 1) * step);
        const Vec2 p0 = arc.centre + arc.radius * a, p3 = arc.centre + arc.radius * c;
        add({p0, p0 + arm * perpendicular(a), p3 - arm * perpendicular(c), p3});
      }
    }
  }
  return Curve(std::move(segments));
}

/// Larger about its start, circles staying circles.
Curve enlarged(const Curve& curve, double k) {
  const Vec2 from = curve.start();
  const auto place = [&](Vec2 p) { return from + k * (p - from); };
  std::vector<Segment> segments;
  for (const Segment& segment : curve.segments()) {
    if (const auto* line = std::get_if<LineSegment>(&segment)) {
      segments.emplace_back(LineSegment{place(line->from), place(line->to)});
    } else if (const auto* arc = std::get_if<ArcSegment>(&segment)) {
      segments.emplace_back(ArcSegment{place(arc->centre), k * arc->radius, arc->start, arc->sweep});
    } else {
      const auto& b = std::get<BezierSegment>(segment);
      segments.emplace_back(BezierSegment{place(b.p0), place(b.p1), place(b.p2), place(b.p3)});
    }
  }
  return Curve(std::move(segments));
}

std::optional<Curve> stretched_across(const Curve& curve, double length) {
  const Vec2 from = curve.start();
  const Vec2 along = (curve.end() - from) / distance(from, curve.end());
  const auto place = [&](Vec2 p, double k) {
    return from + dot(p - from, along) * along + k * cross(along, p - from) * perpendicular(along);
  };
  return member_of_length([&](double k) { return placed_anew(curve, k, place); }, 0, most_growth, length);
}

}  // namespace

std::optional<Curve> of_length(const Curve& curve, double length) {
  if (curve.empty() || !(length > 0)) return std::nullopt;
  const double now = curve.length(), apart = distance(curve.start(), curve.end());
  if (std::abs(now - length) <= 1e-15 * length) return curve;
  if (apart < touching_ends) return now > 0 ? std::optional(enlarged(curve, length / now)) : std::nullopt;
  if (!(length > apart)) return std::nullopt;
  if (curve.segments().size() > 1) return stretched_across(curve, length);
  if (const auto* arc = std::get_if<ArcSegment>(&curve.segments()[0])) return longer_arc(*arc, length);
  if (const auto* b = std::get_if<BezierSegment>(&curve.segments()[0])) return longer_arms(*b, length);
  return std::nullopt;
}

}  // namespace toile
