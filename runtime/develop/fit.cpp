#include "runtime/develop/fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/curve/places.hpp"
#include "compiler/curve/shape.hpp"

namespace toile {
namespace {

constexpr double micrometre = 1e-6;
constexpr double degree = std::numbers::pi / 180;
constexpr double end_share = 0.2;  // of the line's length, from which the direction at its end is read

double rounded_angle(double angle) {
  return std::round(angle / (1e-3 * degree)) * 1e-3 * degree;
}

std::vector<double> arc_lengths(const std::vector<Vec2>& points) {
  std::vector<double> arc{0};
  for (std::size_t i = 1; i < points.size(); ++i) arc.push_back(arc.back() + distance(points[i - 1], points[i]));
  return arc;
}

/// The direction at the start of a line of points, from the parabola over its arc length that starts at the first and
/// fits best to those that follow.
double direction_at_start(const std::vector<Vec2>& points) {
  const std::vector<double> arc = arc_lengths(points);
  const double reach = end_share * arc.back();
  double s2 = 0, s3 = 0, s4 = 0;
  Vec2 d1, d2;
  for (std::size_t i = 1; i < points.size() && (i < 4 || arc[i] <= reach); ++i) {
    const double s = arc[i];
    s2 += s * s;
    s3 += s * s * s;
    s4 += s * s * s * s;
    d1 = d1 + s * (points[i] - points[0]);
    d2 = d2 + s * s * (points[i] - points[0]);
  }
  const double determinant = s2 * s4 - s3 * s3;
  const Vec2 tangent = determinant > 1e-12 * s2 * s4 ? s4 * d1 - s3 * d2 : points[1] - points[0];
  return rounded_angle(std::atan2(tangent.y, tangent.x));
}

double farthest(const Curve& curve, const std::vector<Vec2>& solved) {
  double worst = 0;
  for (const Vec2 point : solved) worst = std::max(worst, distance(point, curve.at(nearest_place(curve, point))));
  return worst;
}

/// Through `count` of the solved points between the ends, evenly spaced.
std::vector<Vec2> chosen(const std::vector<Vec2>& solved, std::size_t count) {
  const std::vector<double> arc = arc_lengths(solved);
  std::vector<Vec2> points{rounded(solved.front())};
  std::size_t before = 0;
  for (std::size_t k = 1; k <= count; ++k) {
    const double wanted = arc.back() * static_cast<double>(k) / static_cast<double>(count + 1);
    const auto after = std::lower_bound(arc.begin(), arc.end(), wanted) - arc.begin();
    std::size_t nearest = static_cast<std::size_t>(after);
    if (nearest > 0 && wanted - arc[nearest - 1] < arc[nearest] - wanted) --nearest;
    if (nearest <= before || nearest + 1 >= solved.size()) continue;
    points.push_back(rounded(solved[nearest]));
    before = nearest;
  }
  points.push_back(rounded(solved.back()));
  return points;
}

}  // namespace

Vec2 rounded(Vec2 point) {
  return {std::round(point.x / micrometre) * micrometre, std::round(point.y / micrometre) * micrometre};
}

FittedCurve fit_curve(const std::vector<Vec2>& solved, double tolerance) {
  FittedCurve fitted;
  fitted.points = chosen(solved, 0);
  fitted.curve = line(fitted.points.front(), fitted.points.back());
  fitted.error = farthest(fitted.curve, solved);
  if (fitted.error <= tolerance || solved.size() < 3) return fitted;
  const std::vector<Vec2> backwards(solved.rbegin(), solved.rend());
  const double leaving = direction_at_start(solved);
  const double back = direction_at_start(backwards);
  const double arriving = rounded_angle(back > 0 ? back - std::numbers::pi : back + std::numbers::pi);
  for (std::size_t count = 0; count + 2 <= solved.size(); count += 1 + count / 3) {
    fitted.points = chosen(solved, count);
    fitted.leaving = leaving;
    fitted.arriving = arriving;
    fitted.curve = fitted.points.size() == 2
                       ? tangent_curve(fitted.points.front(), leaving, fitted.points.back(), arriving)
                       : spline(fitted.points, leaving, arriving);
    fitted.error = farthest(fitted.curve, solved);
    if (fitted.error <= tolerance) break;
  }
  return fitted;
}

}  // namespace toile
