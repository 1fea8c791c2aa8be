// Arc length of a cubic: Gauss-Legendre quadrature of the speed, halving the interval until two orders of subdivision
// agree. Halving closes in on cusps, where the speed is no polynomial, geometrically fast.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compiler/curve/segment.hpp"

namespace toile {
namespace {

constexpr int kOrder = 12;
constexpr int kDeepest = 40;
constexpr double kTolerance = 1e-14;  // [m] per interval; relative to the whole for curves longer than a metre

struct Rule {
  std::array<double, kOrder> node{};  // in [-1, 1]
  std::array<double, kOrder> weight{};
};

// Roots of the Legendre polynomial by Newton from Tricomi's asymptotic guess.
Rule gauss_legendre() {
  Rule rule;
  for (int i = 0; i < kOrder; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (kOrder + 0.5));
    double slope = 1;
    for (int step = 0; step < 20; ++step) {
      double value = x, before = 1;
      for (int n = 2; n <= kOrder; ++n) {
        const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
        before = value;
        value = next;
      }
      slope = kOrder * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    rule.node[i] = x;
    rule.weight[i] = 2 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

double quadrature(const BezierSegment& bezier, double t0, double t1) {
  static const Rule rule = gauss_legendre();
  const Vec2 a = 3 * (bezier.p1 - bezier.p0), b = 3 * (bezier.p2 - bezier.p1), c = 3 * (bezier.p3 - bezier.p2);
  const double middle = (t0 + t1) / 2, half = (t1 - t0) / 2;
  double sum = 0;
  for (int i = 0; i < kOrder; ++i) {
    const double t = middle + half * rule.node[i], u = 1 - t;
    const Vec2 d = u * u * a + 2 * u * t * b + t * t * c;
    sum += rule.weight[i] * std::sqrt(dot(d, d));
  }
  return half * sum;
}

double adaptive(const BezierSegment& bezier, double t0, double t1, double coarse, double tolerance, int depth) {
  const double middle = (t0 + t1) / 2;
  const double left = quadrature(bezier, t0, middle), right = quadrature(bezier, middle, t1);
  const bool disagree = std::abs(left + right - coarse) > tolerance;  // false for NaN: nothing to be gained
  if (!disagree || depth >= kDeepest) return left + right;
  return adaptive(bezier, t0, middle, left, tolerance, depth + 1) +
         adaptive(bezier, middle, t1, right, tolerance, depth + 1);
}

}  // namespace

double bezier_length(const BezierSegment& bezier, double t0, double t1) {
  const double coarse = quadrature(bezier, t0, t1);
  if (!std::isfinite(coarse)) return coarse;
  return adaptive(bezier, t0, t1, coarse, kTolerance * std::max(1.0, coarse), 0);
}

}  // namespace toile
