#include <algorithm>
#include <cmath>

#include "compiler/curve/shape.hpp"

namespace toile {
namespace {

constexpr double kMet = 1e-11;  // [m]
constexpr int kSteps = 80;

// The point at `radius` to the left of a place of a curve, and how it moves with the place.
struct Beside {
  Vec2 at, moves;

  Beside(const Curve& curve, double s, double radius) {
    const Vec2 along = curve.tangent(s);
    at = curve.at(s) + radius * perpendicular(along);
    moves = (1 - radius * curve.curvature(s)) * along;
  }
};

}  // namespace

std::optional<std::array<Curve, 3>> fillet(const Curve& first, const Curve& second, double radius) {
  const double a = first.length(), b = second.length();
  const Vec2 in = first.tangent(a), out = second.tangent(0);
  const double turn = std::atan2(cross(in, out), dot(in, out));
  if (std::abs(turn) < 1e-6 || !(radius > 0)) return std::nullopt;
  const double left = turn > 0 ? radius : -radius;  // the side on which the centre lies
  // Of straight lines the arc begins so far from their corner.
  const double guess = radius * std::tan(std::abs(turn) / 2);
  double s = a - std::min(guess, 0.9 * a), t = std::min(guess, 0.9 * b);
  for (int step = 0; step < kSteps; ++step) {
    const Beside one(first, s, left), other(second, t, left);
    const Vec2 apart = other.at - one.at;
    if (norm(apart) < kMet) {
      if (s < kMet || t > b - kMet || s > a - kMet || t < kMet) return std::nullopt;
      const Vec2 from = first.at(s), to = second.at(t), centre = one.at;
      const double begin = std::atan2(from.y - centre.y, from.x - centre.x);
      const double sweep = std::atan2(cross(from - centre, to - centre), dot(from - centre, to - centre));
      // A corner is rounded by less than half a circle, on the side of its turn.
      if (sweep * left <= 0) return std::nullopt;
      return std::array{first.part(0, s), arc_about(centre, radius, begin, begin + sweep), second.part(t, b)};
    }
    const double det = cross(one.moves, other.moves);
    if (std::abs(det) < 1e-14) return std::nullopt;
    const double ds = cross(apart, other.moves) / det, dt = cross(apart, one.moves) / det;
    s = std::clamp(s + ds, 0.5 * s, 0.5 * (s + a));
    t = std::clamp(t + dt, 0.5 * t, 0.5 * (t + b));
  }
  return std::nullopt;
}

}  // namespace toile
