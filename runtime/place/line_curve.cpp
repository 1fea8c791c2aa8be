#include "runtime/place/line_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {

ClosedCurve::ClosedCurve(std::vector<Vec3> points) : points_(std::move(points)), arc_{0} {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    arc_.push_back(arc_.back() + distance(points_[i], points_[(i + 1) % points_.size()]));
  }
}

Vec3 ClosedCurve::at(double fraction) const {
  const double s = (fraction - std::floor(fraction)) * length();
  const auto above = std::upper_bound(arc_.begin(), arc_.end() - 1, s);
  const std::size_t i = static_cast<std::size_t>(above - arc_.begin()) - 1;
  const double step = arc_[i + 1] - arc_[i];
  const double t = step > 0 ? std::clamp((s - arc_[i]) / step, 0.0, 1.0) : 0;
  return (1 - t) * points_[i] + t * points_[(i + 1) % points_.size()];
}

double ClosedCurve::fraction_near(Vec3 p) const {
  double best = 0, least = 1e300;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3 from = points_[i], way = points_[(i + 1) % points_.size()] - from;
    const double length2 = dot(way, way);
    const double t = length2 > 0 ? std::clamp(dot(p - from, way) / length2, 0.0, 1.0) : 0;
    const double away = toile::distance(from + t * way, p);
    if (away >= least) continue;
    least = away;
    best = (arc_[i] + t * (arc_[i + 1] - arc_[i])) / length();
  }
  return best;
}

std::vector<Vec3> outward_directions(const BodyLine& line) {
  const std::size_t n = line.points.size();
  std::vector<Vec3> directions(n);
  for (std::size_t i = 0; i < n; ++i) {
    // The line runs counter-clockwise seen along the axis, so its outside is to the right of it.
    const Vec3 along = line.points[(i + 1) % n] - line.points[(i + n - 1) % n];
    const Vec3 out = cross(line.axis, along);
    directions[i] = norm(out) > 1e-12 ? normalized(out) : Vec3{0, -1, 0};
  }
  return directions;
}

ClosedCurve offset(const BodyLine& line, double distance) {
  std::vector<Vec3> points = line.points;
  const std::vector<Vec3> outward = outward_directions(line);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += distance * outward[i];
  return ClosedCurve(std::move(points));
}

ClosedCurve scaled(const BodyLine& line, double length) {
  if (length <= line.girth) return ClosedCurve(line.points);
  double low = 0, high = (length - line.girth) / std::numbers::pi;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (offset(line, middle).length() < length ? low : high) = middle;
  }
  return offset(line, 0.5 * (low + high));
}

}  // namespace toile
