#include "runtime/develop/flips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile {
namespace {

constexpr double most_shrinking = 0.1;  // of its area that one step leaves a triangle at least

/// The least positive root of a t^2 + b t + c for c > 0; infinity when there is none.
double first_root(double a, double b, double c) {
  const double never = std::numeric_limits<double>::infinity();
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return never;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  double least = never;
  if (a != 0 && q / a > 0) least = q / a;
  if (q != 0 && c / q > 0) least = std::min(least, c / q);
  return least;
}

}  // namespace

double step_before_flip(const PlaneCorners& uv, const PlaneCorners& step) {
  const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0], da = step[1] - step[0], db = step[2] - step[0];
  return first_root(cross(da, db), cross(da, b) + cross(a, db), (1 - most_shrinking) * cross(a, b));
}

}  // namespace toile
