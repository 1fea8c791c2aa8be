// Roots and least squares against equations whose solutions are known.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "compiler/solve/least_squares.hpp"
#include "compiler/solve/root.hpp"

namespace toile {
namespace {

TEST(Root, MeetsKnownRoots) {
  int calls = 0;
  const auto cosine = [&](double x) {
    ++calls;
    return std::optional(std::cos(x) - x);
  };
  EXPECT_NEAR(root_within(cosine, {0, 1, 1, std::cos(1.0) - 1}).value(), 0.73908513321516064, 1e-15);
  EXPECT_LT(calls, 12);
  const auto flat = [](double x) { return std::optional(std::pow(x - 0.3, 9)); };
  EXPECT_NEAR(root_within(flat, {0, 1, *flat(0), *flat(1)}).value(), 0.3, 1e-2);
}

TEST(Root, AnEndMayBeTheRoot) {
  const auto line = [](double x) { return std::optional(x); };
  EXPECT_EQ(root_within(line, {0, 1, 0, 1}), 0.0);
  EXPECT_EQ(root_within(line, {-1, 0, -1, 0}), 0.0);
}

TEST(Root, StopsAtAJump) {
  const auto jump = [](double x) { return std::optional(x < 0.25 ? -1.0 : 1.0); };
  EXPECT_NEAR(root_within(jump, {0, 1, -1, 1}).value(), 0.25, 1e-14);
}

TEST(Root, GivesUpWhereThereIsNoValue) {
  const auto hole = [](double x) { return x > 0.2 && x < 0.8 ? std::nullopt : std::optional(x - 0.5); };
  EXPECT_FALSE(root_within(hole, {0, 1, -0.5, 0.5}));
}

TEST(Root, AnyCubicThatRises) {
  EXPECT_TRUE(rc::check("the root of a rising cubic", [] {
    const double root = *rc::gen::inRange(-1000, 1001) / 1000.0;
    const double slope = *rc::gen::inRange(1, 1000) / 100.0;
    const auto cubic = [&](double x) { return std::optional(std::pow(x - root, 3) + slope * (x - root)); };
    RC_ASSERT(std::abs(root_within(cubic, {-1.5, 1.5, *cubic(-1.5), *cubic(1.5)}).value() - root) < 1e-12);
  }));
}

TEST(LeastSquares, TwoCirclesMeet) {
  const Residuals circles = [](const std::vector<double>& p) {
    const double x = p[0], y = p[1];
    return std::optional(std::vector{x * x + y * y - 1, (x - 1) * (x - 1) + y * y - 1});
  };
  const auto fit = least_squares(circles, {{0, 1}, {0, 1}}, 1e-9).value();
  EXPECT_NEAR(fit.at[0], 0.5, 1e-10);
  EXPECT_NEAR(fit.at[1], std::sqrt(3) / 2, 1e-10);
}

TEST(LeastSquares, FindsARootBehindAHill) {
  const Residuals wave = [](const std::vector<double>& p) {
    return std::optional(std::vector{std::sin(3 * std::numbers::pi * p[0]) + 0.3 * p[0] + 0.8, p[1] - p[0]});
  };
  EXPECT_LT(least_squares(wave, {{0, 1}, {0, 1}}, 1e-9)->cost, 1e-18);
}

TEST(LeastSquares, WithoutASolutionGivesTheNearest) {
  const Residuals apart = [](const std::vector<double>& p) { return std::optional(std::vector{p[0] - 1, p[0] + 1}); };
  const auto fit = least_squares(apart, {{-5, 4}}, 1e-9).value();
  EXPECT_NEAR(fit.at[0], 0, 1e-6);
  EXPECT_NEAR(fit.cost, 2, 1e-9);
}

TEST(LeastSquares, StaysInItsRanges) {
  const Residuals far = [](const std::vector<double>& p) {
    EXPECT_TRUE(p[0] >= 0 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1);
    return std::optional(std::vector{p[0] - 3, p[1] - 0.5});
  };
  const auto fit = least_squares(far, {{0, 1}, {0, 1}}, 1e-9).value();
  EXPECT_NEAR(fit.at[0], 1, 1e-9);
  EXPECT_NEAR(fit.at[1], 0.5, 1e-6);
}

TEST(LeastSquares, GivesNothingWhereThereIsNoValueAnywhere) {
  EXPECT_FALSE(least_squares([](const auto&) { return std::nullopt; }, {{0, 1}}, 1e-9));
}

}  // namespace
}  // namespace toile
