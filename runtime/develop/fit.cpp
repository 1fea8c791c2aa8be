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
constexpr double end_share =
    0.25;  // of the first stretch between two points that the direction at its end is read from

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
double direction_at_start(const std::vector<Vec2>& points, double reach) {
  const std::vector<double> arc = arc_lengths(points);
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

/// The solved point that the curve misses most, of those not on it already; nothing when it misses none by much.
std::optional<std::size_t> most_missed(const Curve& curve, const std::vector<Vec2>& solved,
                                       const std::vector<std::size_t>& on_it) {
  std::optional<std::size_t> missed;
  double worst = 0;
  for (std::size_t i = 1; i + 1 < solved.size(); ++i) {
    if (std::find(on_it.begin(), on_it.end(), i) != on_it.end()) continue;
    const double miss = distance(solved[i], curve.at(nearest_place(curve, solved[i])));
    if (miss <= worst) continue;
    worst = miss;
    missed = i;
  }
  return missed;
}

}  // namespace

Vec2 rounded(Vec2 point) {
  return {std::round(point.x / micrometre) * micrometre, std::round(point.y / micrometre) * micrometre};
}

FittedCurve fit_curve(const std::vector<Vec2>& solved, double tolerance) {
  FittedCurve fitted;
  fitted.points = {rounded(solved.front()), rounded(solved.back())};
  fitted.curve = line(fitted.points.front(), fitted.points.back());
  fitted.error = farthest(fitted.curve, solved);
  if (fitted.error <= tolerance || solved.size() < 3) return fitted;
  const std::vector<Vec2> backwards(solved.rbegin(), solved.rend());
  const std::vector<double> arc = arc_lengths(solved);
  std::vector<std::size_t> on_it{0, solved.size() - 1};
  for (;;) {
    // With every point more the ends' directions are read from nearer by: a line may bend sharply at a dart's tip.
    const double back = direction_at_start(backwards, end_share * (arc.back() - arc[on_it[on_it.size() - 2]]));
    fitted.leaving = direction_at_start(solved, end_share * arc[on_it[1]]);
    fitted.arriving = rounded_angle(back > 0 ? back - std::numbers::pi : back + std::numbers::pi);
    fitted.points.clear();
    for (const std::size_t i : on_it) fitted.points.push_back(rounded(solved[i]));
    fitted.curve = on_it.size() == 2
                       ? tangent_curve(fitted.points.front(), *fitted.leaving, fitted.points.back(), *fitted.arriving)
                       : spline(fitted.points, fitted.leaving, fitted.arriving);
    fitted.error = farthest(fitted.curve, solved);
    if (fitted.error <= tolerance) return fitted;
    const auto missed = most_missed(fitted.curve, solved, on_it);
    if (!missed) return fitted;
    on_it.insert(std::upper_bound(on_it.begin(), on_it.end(), *missed), *missed);
  }
}

}  // namespace toile
