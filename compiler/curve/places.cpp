#include "compiler/curve/places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "compiler/curve/bernstein.hpp"
#include "compiler/curve/segment.hpp"

namespace toile {
namespace {

using std::numbers::pi;

constexpr double still = 1e-5;  // [m] off the right direction: found only because the curve has none there

/// A parameter just outside of [0, 1] by rounding is brought in; one further out is no place.
std::optional<double> nearly_within(double t, double length) {
  const double slack = length > 0 ? std::max(1e-12, 1e-9 / length) : 0;
  if (!(t >= -slack && t <= 1 + slack)) return std::nullopt;
  return std::clamp(t, 0.0, 1.0);
}

/// The parameters of an arc that runs more than once round may be several.
std::vector<double> at_angle(const ArcSegment& arc, double angle) {
  std::vector<double> found;
  const double length = arc.radius * std::abs(arc.sweep);
  const double turns = std::copysign(2 * pi, arc.sweep);
  double offset = std::remainder(angle - arc.start, 2 * pi);
  if (offset * arc.sweep < 0) offset += turns;
  for (offset -= turns; std::abs(offset) <= std::abs(arc.sweep) + 2 * pi; offset += turns) {
    if (const auto t = nearly_within(offset / arc.sweep, length)) {
      if (found.empty() || found.back() != *t) found.push_back(*t);
    }
    if (offset / arc.sweep > 1.5) break;
  }
  return found;
}

Bernstein coordinates(const BezierSegment& b, double Vec2::*axis, double from) {
  return {b.p0.*axis - from, b.p1.*axis - from, b.p2.*axis - from, b.p3.*axis - from};
}
Bernstein slopes(const BezierSegment& b, double Vec2::*axis) {
  return {b.p1.*axis - b.p0.*axis, b.p2.*axis - b.p1.*axis, b.p3.*axis - b.p2.*axis};
}
Bernstein negated(Bernstein b) {
  for (double& c : b) c = -c;
  return b;
}

// ---------------------------------------------------------------------------------------------------- feet, touches

std::vector<double> feet_on(const LineSegment& l, Vec2 p) {
  const Vec2 along = l.to - l.from;
  const double square = dot(along, along);
  if (!(square > 0)) return {};
  const auto t = nearly_within(dot(p - l.from, along) / square, std::sqrt(square));
  return t ? std::vector{*t} : std::vector<double>{};
}
std::vector<double> feet_on(const ArcSegment& a, Vec2 p) {
  const Vec2 way = p - a.centre;
  if (!(norm(way) > 1e-12 * a.radius)) return {};
  const double angle = std::atan2(way.y, way.x);
  std::vector<double> found = at_angle(a, angle);
  for (const double t : at_angle(a, angle + pi)) found.push_back(t);
  std::sort(found.begin(), found.end());
  return found;
}
std::vector<double> feet_on(const BezierSegment& b, Vec2 p) {
  std::vector<double> found =
      roots(coordinates(b, &Vec2::x, p.x) * slopes(b, &Vec2::x) + coordinates(b, &Vec2::y, p.y) * slopes(b, &Vec2::y));
  // Where the cubic stands still every way seems square to it.
  std::erase_if(found, [&](double t) { return std::abs(dot(unit_tangent(b, t), p - point(b, t))) > still; });
  return found;
}

std::vector<double> touches_on(const LineSegment&, Vec2) {
  return {};  // a line from the point either lies along it or crosses it
}
std::vector<double> touches_on(const ArcSegment& a, Vec2 p) {
  const Vec2 way = p - a.centre;
  const double far = norm(way);
  if (far < a.radius * (1 - 1e-12)) return {};
  const double aside = std::acos(std::min(1.0, a.radius / far));
  const double angle = std::atan2(way.y, way.x);
  std::vector<double> found = at_angle(a, angle + aside);
  for (const double t : at_angle(a, angle - aside)) {
    if (aside > 0) found.push_back(t);
  }
  std::sort(found.begin(), found.end());
  return found;
}
std::vector<double> touches_on(const BezierSegment& b, Vec2 p) {
  std::vector<double> found = roots(coordinates(b, &Vec2::x, p.x) * slopes(b, &Vec2::y) +
                                    negated(coordinates(b, &Vec2::y, p.y) * slopes(b, &Vec2::x)));
  std::erase_if(found, [&](double t) { return std::abs(cross(unit_tangent(b, t), p - point(b, t))) > still; });
  return found;
}

bool closed(const Curve& curve) {
  constexpr double touching = 1e-9;  // [m]
  return distance(curve.start(), curve.end()) < touching;
}

/// Arc lengths of what `find` gives on each segment, each place once: a closed curve's end is its start.
template <class Find>
std::vector<double> places_along(const Curve& curve, Find find) {
  constexpr double same = 1e-9;  // [m]
  std::vector<double> places;
  double begin = 0;
  for (const Segment& segment : curve.segments()) {
    for (const double t : std::visit(find, segment)) {
      const double s = begin + length_between(segment, 0, t);
      if (places.empty() || s - places.back() > same) places.push_back(s);
    }
    begin += length_between(segment, 0, 1);
  }
  if (places.size() > 1 && closed(curve) && places.front() + begin - places.back() < same) places.pop_back();
  return places;
}

// ---------------------------------------------------------------------------------------------------- meetings

struct Common {
  double t = 0, u = 0;
};
using Commons = std::vector<Common>;

Commons swapped(Commons meetings) {
  for (Common& m : meetings) std::swap(m.t, m.u);
  return meetings;
}

std::optional<double> place_on_line(const LineSegment& l, Vec2 p) {
  const Vec2 along = l.to - l.from;
  return nearly_within(dot(p - l.from, along) / dot(along, along), norm(along));
}

/// Lines along each other share a stretch: its ends.
Commons shared_stretch(const LineSegment& a, const LineSegment& b) {
  const Vec2 d = a.to - a.from;
  if (std::abs(cross(d, b.from - a.from)) > 1e-9 * norm(d)) return {};
  Commons found;
  for (const auto& [end, u] : {std::pair(b.from, 0.0), std::pair(b.to, 1.0)}) {
    if (const auto t = place_on_line(a, end)) found.push_back({*t, u});
  }
  for (const auto& [end, t] : {std::pair(a.from, 0.0), std::pair(a.to, 1.0)}) {
    if (const auto u = place_on_line(b, end)) found.push_back({t, *u});
  }
  return found;
}

Commons meet(const LineSegment& a, const LineSegment& b) {
  const Vec2 d = a.to - a.from, e = b.to - b.from, r = b.from - a.from;
  const double area = cross(d, e);
  if (!(norm(d) > 0 && norm(e) > 0)) return {};
  if (std::abs(area) <= 1e-12 * norm(d) * norm(e)) return shared_stretch(a, b);
  const auto t = nearly_within(cross(r, e) / area, norm(d));
  const auto u = nearly_within(cross(r, d) / area, norm(e));
  return t && u ? Commons{{*t, *u}} : Commons{};
}

Commons meet(const LineSegment& line, const ArcSegment& arc) {
  const Vec2 d = line.to - line.from;
  const double length = norm(d);
  if (!(length > 0)) return {};
  const Vec2 along = d / length, r = arc.centre - line.from;
  const double middle = dot(r, along);
  const double aside = cross(along, r);
  if (std::abs(aside) > arc.radius + 1e-9) return {};
  const double half = std::sqrt(std::max(0.0, arc.radius * arc.radius - aside * aside));
  Commons found;
  for (const double s : {middle - half, middle + half}) {
    const auto t = nearly_within(s / length, length);
    const Vec2 p = line.from + s * along - arc.centre;
    if (!t) continue;
    for (const double u : at_angle(arc, std::atan2(p.y, p.x))) found.push_back({*t, u});
  }
  return found;
}

Commons meet(const ArcSegment& a, const ArcSegment& b) {
  const Vec2 way = b.centre - a.centre;
  const double far = norm(way);
  Commons found;
  const auto add = [&](Vec2 p) {
    const Vec2 from_a = p - a.centre, from_b = p - b.centre;
    for (const double t : at_angle(a, std::atan2(from_a.y, from_a.x))) {
      for (const double u : at_angle(b, std::atan2(from_b.y, from_b.x))) found.push_back({t, u});
    }
  };
  if (far < 1e-9 && std::abs(a.radius - b.radius) < 1e-9) {  // along each other: the ends of what they share
    for (const Vec2 end : {point(a, 0), point(a, 1), point(b, 0), point(b, 1)}) add(end);
    return found;
  }
  if (far < 1e-9 || far > a.radius + b.radius + 1e-9 || far < std::abs(a.radius - b.radius) - 1e-9) return {};
  const double middle = (far * far + a.radius * a.radius - b.radius * b.radius) / (2 * far);
  const double half = std::sqrt(std::max(0.0, a.radius * a.radius - middle * middle));
  const Vec2 along = way / far;
  for (const double side : {half, -half}) add(a.centre + middle * along + side * perpendicular(along));
  return found;
}

Commons meet(const BezierSegment& b, const LineSegment& line) {
  const Vec2 d = line.to - line.from;
  if (!(norm(d) > 0)) return {};
  Bernstein aside;
  for (const Vec2 p : {b.p0, b.p1, b.p2, b.p3}) aside.push_back(cross(d, p - line.from) / norm(d));
  Commons found;
  for (const double t : roots(aside)) {
    if (const auto u = place_on_line(line, point(b, t))) found.push_back({t, *u});
  }
  return found;
}

Commons meet(const BezierSegment& b, const ArcSegment& arc) {
  const Bernstein x = coordinates(b, &Vec2::x, arc.centre.x), y = coordinates(b, &Vec2::y, arc.centre.y);
  const Bernstein square(7, -arc.radius * arc.radius);
  Commons found;
  for (const double t : roots(x * x + y * y + square)) {
    const Vec2 p = point(b, t) - arc.centre;
    for (const double u : at_angle(arc, std::atan2(p.y, p.x))) found.push_back({t, u});
  }
  return found;
}

Commons meet(const BezierSegment& a, const BezierSegment& b) {
  Commons found;
  const Curve first({a}), second({b});
  for (const Crossing& c : meetings(first, second)) {
    found.push_back({parameter_at(a, c.s_first, first.length()), parameter_at(b, c.s_second, second.length())});
  }
  return found;
}

Commons meet(const ArcSegment& a, const LineSegment& l) {
  return swapped(meet(l, a));
}
Commons meet(const LineSegment& l, const BezierSegment& b) {
  return swapped(meet(b, l));
}
Commons meet(const ArcSegment& a, const BezierSegment& b) {
  return swapped(meet(b, a));
}

struct Box {
  Vec2 low, high;
};

Box box_around(std::initializer_list<Vec2> points, double margin) {
  Box box{*points.begin(), *points.begin()};
  for (const Vec2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return {box.low - Vec2{margin, margin}, box.high + Vec2{margin, margin}};
}

/// Around all of the segment; not always the smallest.
Box box_of(const Segment& segment) {
  constexpr double margin = 1e-8;  // [m]
  if (const auto* l = std::get_if<LineSegment>(&segment)) return box_around({l->from, l->to}, margin);
  if (const auto* a = std::get_if<ArcSegment>(&segment)) return box_around({a->centre}, a->radius + margin);
  const auto& b = std::get<BezierSegment>(segment);
  return box_around({b.p0, b.p1, b.p2, b.p3}, margin);
}

bool disjoint(const Box& a, const Box& b) {
  return a.low.x > b.high.x || b.low.x > a.high.x || a.low.y > b.high.y || b.low.y > a.high.y;
}

/// A curve's segments with what is asked of them again and again.
struct Track {
  explicit Track(const Curve& curve) : segments(curve.segments()), length(curve.length()), ring(closed(curve)) {
    double s = 0;
    for (const Segment& segment : segments) {
      boxes.push_back(box_of(segment));
      begins.push_back(s);
      s += length_between(segment, 0, 1);
    }
  }

  /// Whether two arc lengths mean one place.
  bool same(double a, double b) const {
    constexpr double touching = 1e-7;  // [m]
    const double apart = std::abs(a - b);
    return apart < touching || (ring && length - apart < touching);
  }

  const std::vector<Segment>& segments;
  double length;
  bool ring;
  std::vector<Box> boxes;
  std::vector<double> begins;
};

}  // namespace

std::vector<Crossing> intersections(const Curve& first, const Curve& second) {
  const Track one(first), other(second);
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < one.segments.size(); ++i) {
    for (std::size_t j = 0; j < other.segments.size(); ++j) {
      if (disjoint(one.boxes[i], other.boxes[j])) continue;
      const Segment &a = one.segments[i], &b = other.segments[j];
      for (const Common& m : std::visit([](const auto&x, const auto&y) { return meet(x, y); }, a, b)) {
        const Crossing c{one.begins[i] + length_between(a, 0, m.t), other.begins[j] + length_between(b, 0, m.u),
                         point(a, m.t)};
        const bool is_new = std::none_of(found.begin(), found.end(), [&](const Crossing& known) {
          return one.same(known.s_first, c.s_first) && other.same(known.s_second, c.s_second);
        });
        if (is_new) found.push_back(c);
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const Crossing& x, const Crossing& y) {
    return x.s_first != y.s_first ? x.s_first < y.s_first : x.s_second < y.s_second;
  });
  return found;
}

std::vector<double> perpendicular_feet(const Curve& curve, Vec2 p) {
  return places_along(curve, [&](const auto& segment) { return feet_on(segment, p); });
}

std::vector<double> tangent_places(const Curve& curve, Vec2 p) {
  return places_along(curve, [&](const auto& segment) { return touches_on(segment, p); });
}

double nearest_place(const Curve& curve, Vec2 p) {
  std::vector<double> candidates = perpendicular_feet(curve, p);
  double end = 0;
  candidates.push_back(0);
  for (const Segment& segment : curve.segments()) candidates.push_back(end += length_between(segment, 0, 1));
  std::sort(candidates.begin(), candidates.end());
  const auto far = [&](double s) { return distance(curve.at(s), p); };
  return *std::min_element(candidates.begin(), candidates.end(), [&](double a, double b) { return far(a) < far(b); });
}

}  // namespace toile
