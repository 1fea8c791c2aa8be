// Lengths against closed forms, arc-length parametrisation, parts, mirrors, divisions.
#include "compiler/curve/curve.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numbers>

#include "tests/compiler/curve/any_curve.hpp"

namespace toile {
namespace {

using std::numbers::pi;
using test::any_bezier;

void expect_near(Vec2 found, Vec2 wanted, double tolerance) {
  EXPECT_NEAR(found.x, wanted.x, tolerance);
  EXPECT_NEAR(found.y, wanted.y, tolerance);
}

// A straight parabola as a cubic: y = x^2 for 0 <= x <= 1, whose length is known in closed form.
Curve parabola() {
  return bezier({0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1});
}

Curve mixed() {
  return join({line({0, 0}, {0.3, 0.1}), bezier({0.3, 0.1}, {0.5, 0.1}, {0.4, 0.5}, {0.6, 0.6}),
               arc_of_radius({0.6, 0.6}, {0.2, 0.9}, 0.4)});
}

TEST(CurveLength, LinesAndArcsAreExact) {
  EXPECT_DOUBLE_EQ(line({1, 1}, {4, 5}).length(), 5);
  EXPECT_DOUBLE_EQ(circle({3, 2}, {3.25, 2}).length(), 0.5 * pi);
  EXPECT_NEAR(arc_through({1, 0}, {0, 1}, {-1, 0}).length(), pi, 1e-15);
  EXPECT_NEAR(arc_of_radius({1, 0}, {0, 1}, 1).length(), pi / 2, 1e-15);
  EXPECT_NEAR(arc_of_radius({1, 0}, {0, 1}, 1, true).length(), 3 * pi / 2, 1e-15);
}

TEST(CurveLength, ParabolaMeetsItsClosedForm) {
  const double closed_form = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;
  EXPECT_NEAR(parabola().length(), closed_form, 1e-13);
}

TEST(CurveLength, SemicubicalParabolaWithItsCuspMeetsItsClosedForm) {
  // (t^2, t^3) for -1 <= t <= 1: two branches of (13^1.5 - 8) / 27 that meet in a cusp.
  const Curve cusp = bezier({1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1});
  EXPECT_NEAR(cusp.length(), 2 * (std::pow(13, 1.5) - 8) / 27, 1e-12);
}

TEST(CurveLength, FoldedBackOnALineCountsBothWays) {
  // x = 3t(1-t)^2 + ... with the outer controls equal: out to x = 1/2 and back when p1 = p2.
  const Curve folded = bezier({0, 0}, {2.0 / 3, 0}, {2.0 / 3, 0}, {0, 0});
  EXPECT_NEAR(folded.length(), 1, 1e-12);
}

TEST(CurveAt, WalksAtUnitSpeed) {
  const Curve curve = mixed();
  const double h = 1e-6;
  for (int i = 1; i < 40; ++i) {
    const double s = curve.length() * i / 40;
    EXPECT_NEAR(distance(curve.at(s - h), curve.at(s + h)), 2 * h, 1e-9) << "at " << s;
    EXPECT_NEAR(norm(curve.tangent(s)), 1, 1e-12);
  }
  expect_near(curve.at(-1), curve.start(), 0);
  expect_near(curve.at(10), curve.end(), 0);
}

TEST(CurveAt, ParabolaAtAKnownLength) {
  // Up to x = 1/2 the parabola is (sqrt(2) + asinh(1)) / 4 long.
  const double s = (std::sqrt(2.0) + std::asinh(1.0)) / 4;
  expect_near(parabola().at(s), {0.5, 0.25}, 1e-12);
  expect_near(parabola().tangent(s), Vec2{1, 1} / std::sqrt(2.0), 1e-12);
}

TEST(CurveTangent, ExistsWhereControlPointsCoincide) {
  const Curve flat_start = bezier({0, 0}, {0, 0}, {0, 1}, {0, 2});
  expect_near(flat_start.tangent(0), {0, 1}, 1e-9);
  const Curve flat_end = bezier({0, 0}, {1, 0}, {2, 0}, {2, 0});
  expect_near(flat_end.tangent(flat_end.length()), {1, 0}, 1e-9);
}

TEST(CurveArcs, TurnTheWayTheyAreAsked) {
  expect_near(arc_of_radius({0, 0}, {1, 0}, 0.5).at(pi / 4), {0.5, -0.5}, 1e-12);  // left: bulges to the right
  expect_near(arc_of_radius({0, 0}, {1, 0}, -0.5).at(pi / 4), {0.5, 0.5}, 1e-12);
  expect_near(arc_through({0, 0}, {0.2, -0.1}, {0.3, 0.4}).end(), {0.3, 0.4}, 1e-14);
  EXPECT_TRUE(std::holds_alternative<LineSegment>(arc_through({0, 0}, {1, 1}, {2, 2}).segments()[0]));
  expect_near(circle({0, 0}, {1, 0}, false).at(pi / 2), {0, -1}, 1e-12);
}

TEST(TangentCurve, ReproducesAnArc) {
  for (const double turn : {20.0, 60.0, 90.0, -90.0}) {
    const double radians = turn * pi / 180;
    const Curve arc({ArcSegment{{0, 0}, 0.3, 0.4, radians}});
    const double quarter = std::copysign(pi / 2, radians);
    const Curve cubic = tangent_curve(arc.start(), 0.4 + quarter, arc.end(), 0.4 + radians + quarter);
    EXPECT_NEAR(cubic.length(), arc.length(), 3e-4 * arc.length()) << turn;
    for (int i = 0; i <= 10; ++i) {
      EXPECT_NEAR(norm(cubic.at(cubic.length() * i / 10)), 0.3, 0.3 * 3e-4) << turn;
    }
  }
}

TEST(TangentCurve, KeepsItsDirectionsOnALine) {
  const Curve straight = tangent_curve({0, 0}, 0, {0.6, 0}, 0);
  EXPECT_NEAR(straight.length(), 0.6, 1e-14);
  const Curve wave = tangent_curve({0, 0}, pi / 4, {1, 0}, pi / 4);
  expect_near(wave.tangent(0), direction(pi / 4), 1e-12);
  expect_near(wave.tangent(wave.length()), direction(pi / 4), 1e-12);
}

TEST(CurveMoves, MirrorKeepsTheDirectionOfTravel) {
  const Curve curve = mixed();
  const Curve mirrored = curve.mirrored({0.1, 0}, {0, 1});
  for (int i = 0; i <= 8; ++i) {
    const double s = curve.length() * i / 8;
    const Vec2 p = curve.at(s);
    expect_near(mirrored.at(s), {0.2 - p.x, p.y}, 1e-10);
  }
  const Curve turned = curve.rotated(pi / 2, {0.3, 0.1}).moved({-0.3, -0.1});
  expect_near(turned.at(0), {0.1, -0.3}, 1e-12);
}

TEST(CurveDivide, StaysWithinTheChordError) {
  for (const Curve& curve : {mixed(), parabola(), circle({0, 0}, {0.02, 0}), line({0, 0}, {1, 0})}) {
    const double error = 2e-4, longest = 0.05;
    const std::vector<double> cuts = curve.divide(error, longest);
    ASSERT_GE(cuts.size(), 2u);
    EXPECT_EQ(cuts.front(), 0);
    EXPECT_EQ(cuts.back(), curve.length());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      EXPECT_GT(cuts[i], cuts[i - 1]);
      EXPECT_LE(cuts[i] - cuts[i - 1], longest * (1 + 1e-9));
      const Vec2 a = curve.at(cuts[i - 1]), b = curve.at(cuts[i]);
      for (int k = 1; k < 8; ++k) {
        const Vec2 p = curve.at(cuts[i - 1] + (cuts[i] - cuts[i - 1]) * k / 8);
        EXPECT_LE(std::abs(cross(b - a, p - a)) / distance(a, b), error * (1 + 1e-9));
      }
    }
  }
}

TEST(CurveDivide, NeedsNoMoreOnALineThanItsLengthAsks) {
  EXPECT_EQ(line({0, 0}, {1, 0}).divide(1e-4, 0.25).size(), 5u);
  EXPECT_EQ(line({0, 0}, {0, 0}).divide(1e-4, 0.25).size(), 1u);
}

TEST(CurveProperties, PartsAddUpToTheWhole) {
  EXPECT_TRUE(rc::check([] {
    const Curve curve = *any_bezier();
    RC_PRE(curve.length() > 1e-3);
    const double s = curve.length() * *rc::gen::inRange(1, 1000) / 1000.0;
    const Curve head = curve.part(0, s), tail = curve.part(s, curve.length());
    RC_ASSERT(std::abs(head.length() - s) < 1e-11);
    RC_ASSERT(std::abs(head.length() + tail.length() - curve.length()) < 1e-11);
    RC_ASSERT(distance(head.end(), tail.start()) < 1e-12);
  }));
}

TEST(CurveProperties, ReversedTwiceIsTheCurve) {
  EXPECT_TRUE(rc::check([] {
    const Curve curve = *any_bezier();
    const Curve there = curve.reversed(), back = there.reversed();
    RC_ASSERT(std::abs(there.length() - curve.length()) < 1e-11);
    RC_ASSERT(back.start() == curve.start() && back.end() == curve.end());
    RC_ASSERT(distance(back.at(0.3 * curve.length()), curve.at(0.3 * curve.length())) < 1e-10);
  }));
}

TEST(CurveProperties, LengthIsThatOfAFinePolygon) {
  EXPECT_TRUE(rc::check([] {
    const Curve curve = *any_bezier();
    RC_PRE(curve.length() > 1e-3);
    const auto& b = std::get<BezierSegment>(curve.segments()[0]);
    double polygon = 0;
    Vec2 before = b.p0;
    const int n = 20000;
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n, u = 1 - t;
      const Vec2 p = u * u * u * b.p0 + 3 * u * u * t * b.p1 + 3 * u * t * t * b.p2 + t * t * t * b.p3;
      polygon += distance(before, p);
      before = p;
    }
    RC_ASSERT(polygon <= curve.length() + 1e-9);
    RC_ASSERT(polygon > curve.length() - 1e-6);
  }));
}

}  // namespace
}  // namespace toile
