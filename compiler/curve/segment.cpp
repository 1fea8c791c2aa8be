#include "compiler/curve/segment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

using std::numbers::pi;

Vec2 reflect(Vec2 v, Vec2 axis) {
  return 2 * dot(v, axis) * axis - v;
}
Vec2 turn(Vec2 v, double angle) {
  const Vec2 d = direction(angle);
  return {d.x * v.x - d.y * v.y, d.y * v.x + d.x * v.y};
}
Vec2 mix(Vec2 a, Vec2 b, double t) {
  return (1 - t) * a + t * b;
}

Vec2 point_of(const LineSegment& l, double t) {
  return t == 1 ? l.to : l.from + t * (l.to - l.from);
}
Vec2 point_of(const ArcSegment& a, double t) {
  return a.centre + a.radius * direction(a.start + t * a.sweep);
}
Vec2 point_of(const BezierSegment& b, double t) {
  const double u = 1 - t;
  return u * u * u * b.p0 + 3 * u * u * t * b.p1 + 3 * u * t * t * b.p2 + t * t * t * b.p3;
}

Vec2 derivative_of(const LineSegment& l, double) {
  return l.to - l.from;
}
Vec2 derivative_of(const ArcSegment& a, double t) {
  return a.radius * a.sweep * perpendicular(direction(a.start + t * a.sweep));
}
Vec2 derivative_of(const BezierSegment& b, double t) {
  const double u = 1 - t;
  return 3 * (u * u * (b.p1 - b.p0) + 2 * u * t * (b.p2 - b.p1) + t * t * (b.p3 - b.p2));
}

double length_of(const LineSegment& l, double t0, double t1) {
  return (t1 - t0) * distance(l.from, l.to);
}
double length_of(const ArcSegment& a, double t0, double t1) {
  return (t1 - t0) * a.radius * std::abs(a.sweep);
}
double length_of(const BezierSegment& b, double t0, double t1) {
  return bezier_length(b, t0, t1);
}

Segment part_of(const LineSegment& l, double t0, double t1) {
  return LineSegment{point_of(l, t0), point_of(l, t1)};
}
Segment part_of(const ArcSegment& a, double t0, double t1) {
  return ArcSegment{a.centre, a.radius, a.start + t0 * a.sweep, (t1 - t0) * a.sweep};
}
// The blossom (polar form) of the cubic at (t0|t1, …) gives the control points of the part.
Segment part_of(const BezierSegment& b, double t0, double t1) {
  const auto blossom = [&](double r, double s, double t) {
    const Vec2 a = mix(b.p0, b.p1, r), c = mix(b.p1, b.p2, r), e = mix(b.p2, b.p3, r);
    return mix(mix(a, c, s), mix(c, e, s), t);
  };
  return BezierSegment{blossom(t0, t0, t0), blossom(t0, t0, t1), blossom(t0, t1, t1), blossom(t1, t1, t1)};
}

Segment reversed_of(const LineSegment& l) {
  return LineSegment{l.to, l.from};
}
Segment reversed_of(const ArcSegment& a) {
  return ArcSegment{a.centre, a.radius, a.start + a.sweep, -a.sweep};
}
Segment reversed_of(const BezierSegment& b) {
  return BezierSegment{b.p3, b.p2, b.p1, b.p0};
}

Segment mirrored_of(const LineSegment& l, Vec2 p, Vec2 axis) {
  return LineSegment{p + reflect(l.from - p, axis), p + reflect(l.to - p, axis)};
}
Segment mirrored_of(const ArcSegment& a, Vec2 p, Vec2 axis) {
  return ArcSegment{p + reflect(a.centre - p, axis), a.radius, 2 * std::atan2(axis.y, axis.x) - a.start, -a.sweep};
}
Segment mirrored_of(const BezierSegment& b, Vec2 p, Vec2 axis) {
  return BezierSegment{p + reflect(b.p0 - p, axis), p + reflect(b.p1 - p, axis), p + reflect(b.p2 - p, axis),
                       p + reflect(b.p3 - p, axis)};
}

Segment moved_of(const LineSegment& l, Vec2 d) {
  return LineSegment{l.from + d, l.to + d};
}
Segment moved_of(const ArcSegment& a, Vec2 d) {
  return ArcSegment{a.centre + d, a.radius, a.start, a.sweep};
}
Segment moved_of(const BezierSegment& b, Vec2 d) {
  return BezierSegment{b.p0 + d, b.p1 + d, b.p2 + d, b.p3 + d};
}

Segment rotated_of(const LineSegment& l, double angle, Vec2 c) {
  return LineSegment{c + turn(l.from - c, angle), c + turn(l.to - c, angle)};
}
Segment rotated_of(const ArcSegment& a, double angle, Vec2 c) {
  return ArcSegment{c + turn(a.centre - c, angle), a.radius, a.start + angle, a.sweep};
}
Segment rotated_of(const BezierSegment& b, double angle, Vec2 c) {
  return BezierSegment{c + turn(b.p0 - c, angle), c + turn(b.p1 - c, angle), c + turn(b.p2 - c, angle),
                       c + turn(b.p3 - c, angle)};
}

double stray_of(const LineSegment&) {
  return 0;
}
double stray_of(const ArcSegment& a) {
  const double half = std::abs(a.sweep) / 2;
  return half < pi / 2 ? a.radius * (1 - std::cos(half)) : 2 * a.radius;
}
// The distance to a convex set is a convex function, so it is at most the Bernstein mean of the control points'
// distances; the two inner ones weigh at most 3/4 together.
double stray_of(const BezierSegment& b) {
  return 0.75 * std::max(distance_to_segment(b.p1, b.p0, b.p3), distance_to_segment(b.p2, b.p0, b.p3));
}

// Newton on the arc length, kept inside a bracket that every step narrows.
double bezier_parameter_at(const BezierSegment& b, double s, double length) {
  double low = 0, high = 1, s_low = 0;
  double t = s / length;
  for (int step = 0; step < 60; ++step) {
    const double reached = s_low + bezier_length(b, low, t);
    const double excess = reached - s;
    if (std::abs(excess) <= 1e-14 * std::max(1.0, length)) break;
    if (excess > 0) {
      high = t;
    } else {
      low = t;
      s_low = reached;
    }
    const double speed = norm(derivative_of(b, t));
    const double newton = t - excess / speed;
    const double next = newton > low && newton < high ? newton : (low + high) / 2;
    if (next == t) break;
    t = next;
  }
  return t;
}

// Roots in (0, 1) of the derivative's Bernstein quadratic with coefficients a, b, c.
void add_quadratic_roots(double a, double b, double c, std::vector<double>& roots) {
  const double square = a - 2 * b + c, linear = 2 * (b - a);
  const auto keep = [&](double t) {
    if (t > 1e-9 && t < 1 - 1e-9) roots.push_back(t);
  };
  const double discriminant = linear * linear - 4 * square * a;
  if (discriminant < 0) return;
  const double q = -(linear + std::copysign(std::sqrt(discriminant), linear)) / 2;
  if (square != 0) keep(q / square);
  if (q != 0) keep(a / q);
}

std::vector<double> cuts_of(const LineSegment&) {
  return {};
}
std::vector<double> cuts_of(const ArcSegment& a) {
  std::vector<double> cuts;
  const int quarters = static_cast<int>(std::ceil(std::min(std::abs(a.sweep), 8 * pi) / (pi / 2) - 1e-9));
  for (int i = 1; i < quarters; ++i) cuts.push_back(static_cast<double>(i) / quarters);
  return cuts;
}
std::vector<double> cuts_of(const BezierSegment& b) {
  std::vector<double> cuts;
  const Vec2 a = b.p1 - b.p0, m = b.p2 - b.p1, e = b.p3 - b.p2;
  add_quadratic_roots(a.x, m.x, e.x, cuts);
  add_quadratic_roots(a.y, m.y, e.y, cuts);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

}  // namespace

Vec2 point(const Segment& segment, double t) {
  return std::visit([&](const auto& s) { return point_of(s, t); }, segment);
}
Vec2 derivative(const Segment& segment, double t) {
  return std::visit([&](const auto& s) { return derivative_of(s, t); }, segment);
}

Vec2 unit_tangent(const Segment& segment, double t) {
  const Vec2 d = derivative(segment, t);
  const double scale = norm(derivative(segment, 0.5)) + distance(point(segment, 0), point(segment, 1));
  if (norm(d) > 1e-9 * scale) return d / norm(d);
  const double inside = t < 0.5 ? t + 1e-5 : t - 1e-5;
  const Vec2 near = derivative(segment, inside);
  return norm(near) > 0 ? near / norm(near) : Vec2{1, 0};
}

double curvature(const Segment& segment, double t) {
  if (const auto* arc = std::get_if<ArcSegment>(&segment)) return std::copysign(1 / arc->radius, arc->sweep);
  const auto* b = std::get_if<BezierSegment>(&segment);
  if (b == nullptr) return 0;
  const Vec2 first = derivative(segment, t);
  const Vec2 second = 6 * ((1 - t) * (b->p2 - 2 * b->p1 + b->p0) + t * (b->p3 - 2 * b->p2 + b->p1));
  const double speed = norm(first);
  return cross(first, second) / (speed * speed * speed);
}

double length_between(const Segment& segment, double t0, double t1) {
  return std::visit([&](const auto& s) { return length_of(s, t0, t1); }, segment);
}

double parameter_at(const Segment& segment, double s, double length) {
  if (!(s > 0)) return 0;
  if (s >= length) return 1;
  if (const auto* b = std::get_if<BezierSegment>(&segment)) return bezier_parameter_at(*b, s, length);
  return s / length;
}

Segment part(const Segment& segment, double t0, double t1) {
  return std::visit([&](const auto& s) { return part_of(s, t0, t1); }, segment);
}
Segment reversed(const Segment& segment) {
  return std::visit([](const auto& s) { return reversed_of(s); }, segment);
}
Segment mirrored(const Segment& segment, Vec2 point, Vec2 axis) {
  return std::visit([&](const auto& s) { return mirrored_of(s, point, axis); }, segment);
}
Segment moved(const Segment& segment, Vec2 shift) {
  return std::visit([&](const auto& s) { return moved_of(s, shift); }, segment);
}
Segment rotated(const Segment& segment, double angle, Vec2 about) {
  return std::visit([&](const auto& s) { return rotated_of(s, angle, about); }, segment);
}
double stray(const Segment& segment) {
  return std::visit([](const auto& s) { return stray_of(s); }, segment);
}
std::vector<double> monotone_cuts(const Segment& segment) {
  return std::visit([](const auto& s) { return cuts_of(s); }, segment);
}

double distance_to_segment(Vec2 point, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(point - from, along) / square, 0.0, 1.0) : 0.0;
  const Vec2 off = point - (from + t * along);
  return std::sqrt(dot(off, off));  // lengths of cloth: nothing that hypot() would have to save from overflow
}

}  // namespace toile
