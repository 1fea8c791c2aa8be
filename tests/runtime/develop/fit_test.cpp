// Smooth curves for solved points.
#include "runtime/develop/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace toile {
namespace {

constexpr double tolerance = 2e-4;  // [m]

template <class Function>
std::vector<Vec2> sampled(int count, Function at) {
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) points.push_back(at(static_cast<double>(i) / count));
  return points;
}

TEST(Fit, StaysStraightWhereThePointsDo) {
  const FittedCurve fitted = fit_curve(sampled(20,
                                               [](double t) {
                                                 return Vec2{0.3 * t, 1e-4 * std::sin(6 * t)};
                                               }),
                                       tolerance);
  EXPECT_TRUE(fitted.straight());
  EXPECT_EQ(fitted.points.size(), 2u);
}

TEST(Fit, NeedsNoPointBetweenForAPlainArc) {
  const FittedCurve fitted = fit_curve(sampled(30, [](double t) { return 0.2 * direction(0.2 + 1.0 * t); }), tolerance);
  EXPECT_EQ(fitted.points.size(), 2u);
  EXPECT_LE(fitted.error, tolerance);
}

TEST(Fit, KeepsToWavesAndToABendNearTheEnd) {
  const auto wave = sampled(60, [](double t) { return Vec2{0.4 * t, 0.02 * std::sin(12 * t)}; });
  const auto bend = sampled(40, [](double t) { return Vec2{0.15 * t, 0.01 * std::exp(-30 * t)}; });
  for (const auto& points : {wave, bend}) {
    const FittedCurve fitted = fit_curve(points, tolerance);
    EXPECT_LE(fitted.error, tolerance);
    EXPECT_LT(fitted.points.size(), points.size() / 3);
    EXPECT_LT(distance(fitted.curve.start(), points.front()), 1e-6);
    EXPECT_LT(distance(fitted.curve.end(), points.back()), 1e-6);
  }
}

TEST(Fit, SaysPointsToAMicrometre) {
  const Vec2 p = rounded({0.12345678, -0.00000049});
  EXPECT_NEAR(p.x, 0.123457, 1e-15);
  EXPECT_EQ(p.y, 0);
}

}  // namespace
}  // namespace toile
