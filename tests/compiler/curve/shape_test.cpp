// Splines, offsets, prolonged curves and curves of a given length.
#include "compiler/curve/shape.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/curve/places.hpp"
#include "tests/compiler/curve/any_curve.hpp"

namespace toile {
namespace {

using std::numbers::pi;
using test::any_drawn_bezier;
using test::any_place;

void expect_at(Vec2 found, Vec2 wanted, double tolerance = 1e-12) {
  EXPECT_NEAR(found.x, wanted.x, tolerance);
  EXPECT_NEAR(found.y, wanted.y, tolerance);
}

TEST(Fillet, OfTwoLinesTouchesBoth) {
  const auto parts = fillet(line({0, 0}, {0.3, 0}), line({0.3, 0}, {0.3, 0.2}), 0.05);
  ASSERT_TRUE(parts);
  expect_at((*parts)[0].end(), {0.25, 0});
  expect_at((*parts)[2].start(), {0.3, 0.05});
  EXPECT_NEAR((*parts)[1].length(), 0.05 * pi / 2, 1e-12);
}

TEST(Fillet, RunsOnSmoothlyFromCurveToCurve) {
  EXPECT_TRUE(rc::check("directions at both ends of the arc are those of the curves", [] {
    const Vec2 corner = *any_place();
    const double in = 0.01 * *rc::gen::inRange(-300, 300), turn = 0.01 * *rc::gen::inRange(30, 250);
    const double sign = *rc::gen::arbitrary<bool>() ? 1 : -1;
    const Curve first = tangent_curve(corner - 0.5 * direction(in), in + 0.3, corner, in);
    const double out = in + sign * turn;
    const Curve second = tangent_curve(corner, out, corner + 0.5 * direction(out), out - 0.3);
    const double radius = 0.02;
    const auto parts = fillet(first, second, radius);
    RC_ASSERT(parts.has_value());
    const auto& [before, arc, after] = *parts;
    RC_ASSERT(distance(before.end(), arc.start()) < 1e-9 && distance(arc.end(), after.start()) < 1e-9);
    RC_ASSERT(distance(before.tangent(before.length()), arc.tangent(0)) < 1e-7);
    RC_ASSERT(distance(after.tangent(0), arc.tangent(arc.length())) < 1e-7);
    RC_ASSERT(std::abs(std::abs(arc.curvature(0)) - 1 / radius) < 1e-6 / radius);
  }));
}

TEST(Fillet, NeedsACornerAndRoom) {
  EXPECT_FALSE(fillet(line({0, 0}, {0.3, 0}), line({0.3, 0}, {0.6, 0}), 0.05));
  EXPECT_FALSE(fillet(line({0, 0}, {0.3, 0}), line({0.3, 0}, {0.3, 0.2}), 0.25));
}

TEST(Spline, OfPointsOnALineIsTheLine) {
  const Curve curve = spline({{0, 0}, {1, 1}, {3, 3}, {4, 4}});
  EXPECT_NEAR(curve.length(), std::sqrt(32), 1e-12);
  expect_at(curve.tangent(2), {std::sqrt(0.5), std::sqrt(0.5)});
}

TEST(Spline, PassesThroughItsPointsSmoothly) {
  EXPECT_TRUE(rc::check("direction and curvature run on", [] {
    std::vector<Vec2> points;
    const int count = *rc::gen::inRange(2, 9);
    for (int i = 0; i < count; ++i) points.push_back(Vec2{0.3 * i, 0} + 0.1 * *any_place());
    const Curve curve = spline(points, 0.5, -0.5);
    RC_ASSERT(curve.segments().size() == points.size() - 1);
    RC_ASSERT(distance(curve.tangent(0), direction(0.5)) < 1e-9);
    RC_ASSERT(distance(curve.tangent(curve.length()), direction(-0.5)) < 1e-9);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const auto& before = std::get<BezierSegment>(curve.segments()[i - 1]);
      const auto& after = std::get<BezierSegment>(curve.segments()[i]);
      RC_ASSERT(distance(after.p0, points[i]) < 1e-12);
      const double a = distance(before.p0, before.p3), b = distance(after.p0, after.p3);
      RC_ASSERT(distance((before.p3 - before.p2) / a, (after.p1 - after.p0) / b) < 1e-9);
      const Vec2 left = (before.p3 - 2 * before.p2 + before.p1) / (a * a);
      const Vec2 right = (after.p2 - 2 * after.p1 + after.p0) / (b * b);
      RC_ASSERT(distance(left, right) < 1e-8);
    }
  }));
}

TEST(Spline, ClosedThroughTheCornersOfASquareIsNearlyACircle) {
  const Curve curve = closed_spline({{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  expect_at(curve.end(), curve.start());
  expect_at(curve.tangent(0), {0, 1});
  expect_at(curve.tangent(curve.length()), {0, 1});
  for (int i = 0; i < 16; ++i) EXPECT_NEAR(norm(curve.at(curve.length() * i / 16)), 1, 0.06);
  EXPECT_NEAR(curve.at(curve.length() / 8).x, curve.at(curve.length() / 8).y, 1e-12);
}

TEST(ArcAbout, TurnsTowardsItsSecondAngle) {
  const Curve left = arc_about({1, 1}, 2, 0, pi / 2);
  expect_at(left.start(), {3, 1});
  expect_at(left.end(), {1, 3});
  expect_at(left.tangent(0), {0, 1});
  expect_at(arc_about({0, 0}, 1, 0, -pi / 2).end(), {0, -1});
}

TEST(Extended, GoesOnAsItEnds) {
  const Curve straight = extended(line({0, 0}, {1, 0}), 0.5, 2);
  expect_at(straight.start(), {-0.5, 0});
  expect_at(straight.end(), {3, 0});
  const Curve round = extended(arc_about({0, 0}, 1, 0, pi / 2), pi / 2, pi / 2);
  expect_at(round.start(), {0, -1});
  expect_at(round.end(), {-1, 0});
  const Curve bent = extended(bezier({0, 0}, {1, 0}, {2, 1}, {2, 2}), 1, 1);
  expect_at(bent.start(), {-1, 0});
  expect_at(bent.end(), {2, 3});
}

TEST(Offset, OfLinesAndArcsIsExact) {
  const Curve corner = join({line({0, 0}, {4, 0}), line({4, 0}, {4, 4})});
  const Curve inside = offset(corner, 1).value();
  EXPECT_EQ(inside.segments().size(), 2u);
  EXPECT_NEAR(inside.length(), 6, 1e-12);
  expect_at(inside.at(3), {3, 1});
  const Curve outside = offset(corner, -1).value();
  EXPECT_NEAR(outside.length(), 8 + pi / 2, 1e-12);
  EXPECT_NEAR(offset(circle({0, 0}, {2, 0}), 0.5)->length(), 3 * pi, 1e-12);
  EXPECT_NEAR(offset(circle({0, 0}, {2, 0}), -0.5)->length(), 5 * pi, 1e-12);
}

TEST(Offset, WhatWouldFoldIsCutOff) {
  EXPECT_FALSE(offset(circle({0, 0}, {1, 0}), 1.5));
  // A notch 1 wide and 2 deep, from above: at 0.6 nothing of its inside is left.
  const Curve notch = join({line({0, 0}, {3, 0}), line({3, 0}, {3, -2}), line({3, -2}, {4, -2}), line({4, -2}, {4, 0}),
                            line({4, 0}, {7, 0})});
  const Curve above = offset(notch, 0.6).value();
  for (int i = 0; i <= 50; ++i) EXPECT_GE(above.at(above.length() * i / 50).y, 0.3);
  EXPECT_TRUE(self_crossings(above).empty());
}

TEST(Offset, OfACubicHasLostItsCusps) {
  const Curve tight = bezier({0, 0}, {0.1, 0.4}, {0.2, 0.4}, {0.3, 0});
  const Curve inside = offset(tight, -0.12).value();  // more than the radius at the top
  EXPECT_TRUE(self_crossings(inside).empty());
  for (int i = 0; i <= 50; ++i) {
    const Vec2 p = inside.at(inside.length() * i / 50);
    EXPECT_NEAR(distance(tight.at(nearest_place(tight, p)), p), 0.12, 2e-6);
  }
}

TEST(Offset, KeepsItsDistance) {
  EXPECT_TRUE(rc::check("no point of an offset is nearer or farther", [] {
    const Curve curve = *any_drawn_bezier();
    const double d = *rc::gen::inRange(-100, 101) / 1000.0;
    if (d == 0 || curve.length() < 0.01) return;
    const auto aside = offset(curve, d);
    if (!aside) return;
    for (int i = 0; i <= 20; ++i) {
      const Vec2 p = aside->at(aside->length() * i / 20);
      RC_ASSERT(std::abs(distance(curve.at(nearest_place(curve, p)), p) - std::abs(d)) < 1e-5);
    }
  }));
}

TEST(OfLength, AnArcKeepsItsEnds) {
  const Curve arc = arc_through({-1, 0}, {0, 0.1}, {1, 0});
  const Curve half_round = of_length(arc, pi).value();
  EXPECT_NEAR(half_round.length(), pi, 1e-12);
  expect_at(half_round.at(pi / 2), {0, 1}, 1e-9);
  expect_at(half_round.end(), {1, 0}, 1e-9);
}

TEST(OfLength, ABezierKeepsItsEndsAndDirections) {
  const Curve curve = tangent_curve({0, 0}, 0.8, {0.3, 0.1}, -0.4);
  const Curve longer = of_length(curve, 0.35).value();
  EXPECT_NEAR(longer.length(), 0.35, 1e-12);
  expect_at(longer.tangent(0), direction(0.8));
  expect_at(longer.tangent(0.35), direction(-0.4));
}

TEST(OfLength, AChainIsStretchedAcross) {
  const Curve chain = join({line({0, 0}, {1, 0.5}), arc_of_radius({1, 0.5}, {2, 0.5}, -0.6), line({2, 0.5}, {3, 0})});
  const Curve longer = of_length(chain, 4).value();
  EXPECT_NEAR(longer.length(), 4, 1e-12);
  expect_at(longer.end(), {3, 0});
  EXPECT_NEAR(of_length(circle({0, 0}, {1, 0}), 1)->length(), 1, 1e-12);
}

TEST(OfLength, WhatCannotBeIsNothing) {
  EXPECT_FALSE(of_length(line({0, 0}, {1, 0}), 2));
  EXPECT_FALSE(of_length(tangent_curve({0, 0}, 0.5, {1, 0}, -0.5), 0.99));
  EXPECT_FALSE(of_length(bezier({0, 0}, {1, 1}, {0, 1}, {1, 0}), 40));  // a loop
}

TEST(Curvature, OfCirclesAndParabolas) {
  EXPECT_NEAR(circle({0, 0}, {2, 0}).curvature(1), 0.5, 1e-15);
  EXPECT_NEAR(circle({0, 0}, {2, 0}, false).curvature(1), -0.5, 1e-15);
  EXPECT_EQ(line({0, 0}, {1, 1}).curvature(0.5), 0);
  EXPECT_NEAR(bezier({0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1}).curvature(0), 2, 1e-12);
}

}  // namespace
}  // namespace toile
