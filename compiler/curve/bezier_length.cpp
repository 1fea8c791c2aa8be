// Arc length of a cubic: Gauss-Legendre quadrature of the speed, halving the interval until two orders of subdivision
// agree. Halving closes in on cusps, where the speed is no polynomial, geometrically fast.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
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

double measured(const BezierSegment& bezier, double t0, double t1) {
  const double coarse = quadrature(bezier, t0, t1);
  if (!std::isfinite(coarse)) return coarse;
  return adaptive(bezier, t0, t1, coarse, kTolerance * std::max(1.0, coarse), 0);
}

// Curves are joined, copied and cut out of each other, and the same cubic is measured over and over: the lengths of
// whole ones are remembered, each in the place that its control points choose. What is remembered is what was
// computed, so no result depends on it.
class Remembered {
 public:
  double length(const BezierSegment& bezier) {
    const std::array<double, 8> key{bezier.p0.x, bezier.p0.y, bezier.p1.x, bezier.p1.y,
                                    bezier.p2.x, bezier.p2.y, bezier.p3.x, bezier.p3.y};
    std::uint64_t hash = 0;
    for (const double number : key) hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15u;
    Entry& entry = entries_[hash >> (64 - kBits)];
    if (!entry.known || entry.key != key) entry = {key, measured(bezier, 0, 1), true};
    return entry.length;
  }

 private:
  static constexpr int kBits = 9;
  struct Entry {
    std::array<double, 8> key{};
    double length = 0;
    bool known = false;
  };

  std::array<Entry, 1 << kBits> entries_{};
};

}  // namespace

double bezier_length(const BezierSegment& bezier, double t0, double t1) {
  thread_local Remembered remembered;
  if (t0 == 0 && t1 == 1) return remembered.length(bezier);
  return measured(bezier, t0, t1);
}

}  // namespace toile
