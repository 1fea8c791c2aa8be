#include "compiler/pattern/region.hpp"

#include <array>
#include <cmath>
#include <variant>

namespace toile {
namespace {

constexpr double kChordError = 1e-5;  // [m]

// The area swept from the origin: half the integral of cross(p, dp).
double swept(const LineSegment& l) {
  return cross(l.from, l.to) / 2;
}
double swept(const ArcSegment& a) {
  const Vec2 from = a.radius * direction(a.start), to = a.radius * direction(a.start + a.sweep);
  return (a.radius * a.radius * a.sweep + cross(a.centre, to - from)) / 2;
}
// The integrand is a polynomial of the fifth degree: three Gauss points are exact.
double swept(const BezierSegment& b) {
  const double outer = std::sqrt(0.6) / 2;
  const std::array<std::array<double, 2>, 3> rule{{{0.5 - outer, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + outer, 5.0 / 18}}};
  double sum = 0;
  for (const auto [t, weight] : rule) {
    const double u = 1 - t;
    const Vec2 p = u * u * u * b.p0 + 3 * u * u * t * b.p1 + 3 * u * t * t * b.p2 + t * t * t * b.p3;
    const Vec2 d = 3 * (u * u * (b.p1 - b.p0) + 2 * u * t * (b.p2 - b.p1) + t * t * (b.p3 - b.p2));
    sum += weight * cross(p, d) / 2;
  }
  return sum;
}

}  // namespace

double signed_area(const Curve& closed) {
  double area = 0;
  for (const Segment& segment : closed.segments()) {
    area += std::visit([](const auto& s) { return swept(s); }, segment);
  }
  return area;
}

Curve whole_outline(const std::vector<PieceEdge>& edges) {
  std::vector<Curve> curves;
  curves.reserve(edges.size());
  for (const PieceEdge& edge : edges) curves.push_back(edge.curve);
  return join(curves);
}

Region::Region(const Curve& closed) {
  polygon_ = closed.polygon(kChordError);
  polygon_.pop_back();  // the first again
}

Region::Region(const std::vector<PieceEdge>& loop) {
  for (const PieceEdge& edge : loop) {
    const std::vector<Vec2> points = edge.curve.polygon(kChordError);
    polygon_.insert(polygon_.end(), points.begin(), points.end() - 1);
  }
}

bool Region::contains(Vec2 point) const {
  bool inside = false;
  for (std::size_t i = 0, j = polygon_.size() - 1; i < polygon_.size(); j = i++) {
    const Vec2 a = polygon_[i], b = polygon_[j];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

}  // namespace toile
