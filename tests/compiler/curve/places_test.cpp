// Where curves meet, perpendiculars fall and lines touch: closed forms, and properties of any curve.
#include "compiler/curve/places.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "compiler/curve/bernstein.hpp"
#include "tests/compiler/curve/any_curve.hpp"

namespace toile {
namespace {

using std::numbers::pi;
using test::any_bezier;
using test::any_curve;
using test::any_place;

TEST(Bernstein, RootsOfAQuartic) {
  // (t - 1/4)(t - 3/4)(t - 1)t, as a product of lines.
  const auto line = [](double root) { return Bernstein{-root, 1 - root}; };
  const std::vector<double> found = roots(line(0.25) * line(0.75) * line(1) * line(0));
  ASSERT_EQ(found.size(), 4u);
  EXPECT_NEAR(found[0], 0, 1e-12);
  EXPECT_NEAR(found[1], 0.25, 1e-12);
  EXPECT_NEAR(found[2], 0.75, 1e-12);
  EXPECT_NEAR(found[3], 1, 1e-12);
}

TEST(Bernstein, ATouchingRootCountsOnce) {
  const Bernstein line{-0.3, 0.7};
  const std::vector<double> found = roots(line * line);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0], 0.3, 1e-7);
  EXPECT_TRUE(roots(line * line + Bernstein{1e-6, 1e-6, 1e-6}).empty());
  EXPECT_TRUE(roots({0, 0, 0}).empty());
}

TEST(Intersections, OfLines) {
  const auto found = intersections(line({0, 0}, {1, 1}), line({0, 1}, {1, 0}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].s_first, std::sqrt(0.5), 1e-15);
  EXPECT_EQ(found[0].point, (Vec2{0.5, 0.5}));
  EXPECT_EQ(intersections(line({0, 0}, {1, 0}), line({1, 0}, {1, 1})).size(), 1u);  // at their ends
  EXPECT_TRUE(intersections(line({0, 0}, {1, 0}), line({0, 1e-6}, {1, 1e-6})).empty());
}

TEST(Intersections, LinesAlongEachOtherMeetAtTheEndsOfWhatTheyShare) {
  const auto found = intersections(line({0, 0}, {3, 0}), line({2, 0}, {1, 0}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].point, (Vec2{1, 0}));
  EXPECT_EQ(found[1].point, (Vec2{2, 0}));
}

TEST(Intersections, OfALineAndACircleInTheOrderOfTheFirst) {
  const Curve round = circle({0, 0}, {5, 0}), across = line({6, 3}, {-6, 3});
  const auto found = intersections(across, round);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].point.x, 4, 1e-14);
  EXPECT_NEAR(found[1].point.x, -4, 1e-14);
  const auto other = intersections(round, across);
  ASSERT_EQ(other.size(), 2u);
  EXPECT_NEAR(other[0].s_first, 5 * std::asin(0.6), 1e-13);
  EXPECT_NEAR(other[1].s_first, 5 * (pi - std::asin(0.6)), 1e-13);
}

TEST(Intersections, ATangentLineTouchesOnce) {
  const auto found = intersections(line({-1, 0.5}, {1, 0.5}), circle({0, 0}, {0.5, 0}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].s_first, 1, 1e-7);
}

TEST(Intersections, OfCircles) {
  const auto found = intersections(circle({0, 0}, {1, 0}), circle({1, 0}, {2, 0}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].s_first, pi / 3, 1e-14);
  EXPECT_NEAR(found[1].s_first, 5 * pi / 3, 1e-14);
  EXPECT_EQ(intersections(circle({0, 0}, {0, 1}), circle({3, 0}, {3, 2}, false)).size(), 1u);  // touching
  EXPECT_TRUE(intersections(circle({0, 0}, {1, 0}), circle({0.1, 0}, {0.2, 0})).empty());
}

TEST(Intersections, TheEndOfAClosedCurveIsItsStart) {
  const Curve round = circle({0, 0}, {1, 0});
  EXPECT_EQ(intersections(line({-2, 0}, {2, 0}), round).size(), 2u);
  EXPECT_EQ(intersections(round, line({0, 0}, {2, 0})).size(), 1u);
  EXPECT_EQ(perpendicular_feet(round, {3, 0}).size(), 2u);
}

TEST(Intersections, OfAParabola) {
  const Curve parabola = bezier({0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1});  // y = x^2
  const auto straight = intersections(parabola, line({0, 0.25}, {1, 0.25}));
  ASSERT_EQ(straight.size(), 1u);
  EXPECT_NEAR(straight[0].point.x, 0.5, 1e-14);
  const auto round = intersections(parabola, circle({0, 0}, {std::sqrt(2.0), 0}));
  ASSERT_EQ(round.size(), 1u);  // (1, 1), the end
  EXPECT_NEAR(round[0].point.x, 1, 1e-9);
  const Curve sideways = bezier({0, 0}, {0, 1.0 / 3}, {1.0 / 3, 2.0 / 3}, {1, 1});  // x = y^2
  const auto both = intersections(parabola, sideways);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_NEAR(both[0].s_first, 0, 1e-6);
  EXPECT_NEAR(both[1].point.y, 1, 1e-6);
}

TEST(Intersections, LieOnBothCurvesAndRunAlongTheFirst) {
  EXPECT_TRUE(rc::check("intersections lie on both", [] {
    const Curve a = *any_curve(), b = *any_curve();
    double before = -1;
    for (const Crossing& c : intersections(a, b)) {
      RC_ASSERT(distance(a.at(c.s_first), c.point) < 1e-9);
      RC_ASSERT(distance(b.at(c.s_second), c.point) < 2e-8);
      RC_ASSERT(c.s_first >= before);
      before = c.s_first;
    }
  }));
}

TEST(Intersections, AreThoseOfTheSearchByHalves) {
  EXPECT_TRUE(rc::check("polynomials and halving agree", [] {
    const Curve a = *any_bezier(), b = line(*any_place(), *any_place());
    if (b.length() < 1e-3) return;
    for (const Crossing& c : meetings(a, b)) {
      bool near = false;
      for (const Crossing& other : intersections(a, b)) near = near || distance(c.point, other.point) < 1e-4;
      RC_ASSERT(near);
    }
  }));
}

/// At a joint of segments either of their directions counts.
template <class Measure>
double least_about(const Curve& curve, double s, Measure measure) {
  return std::min({measure(curve.tangent(s)), measure(curve.tangent(s - 1e-8)), measure(curve.tangent(s + 1e-8))});
}

TEST(Feet, OnLinesArcsAndParabolas) {
  const auto on_line = perpendicular_feet(line({0, 0}, {4, 0}), {1, 3});
  ASSERT_EQ(on_line.size(), 1u);
  EXPECT_NEAR(on_line[0], 1, 1e-15);
  EXPECT_TRUE(perpendicular_feet(line({0, 0}, {4, 0}), {5, 3}).empty());
  const auto on_circle = perpendicular_feet(circle({0, 0}, {2, 0}), {0, 1});
  ASSERT_EQ(on_circle.size(), 2u);
  EXPECT_NEAR(on_circle[0], pi, 1e-14);
  EXPECT_NEAR(on_circle[1], 3 * pi, 1e-14);
  EXPECT_TRUE(perpendicular_feet(circle({0, 0}, {2, 0}), {0, 0}).empty());
  // From (0, 5/4) the feet on y = x^2 are 0 and sqrt(3)/2.
  const Curve parabola = bezier({0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1});
  const auto feet = perpendicular_feet(parabola, {0, 1.25});
  ASSERT_EQ(feet.size(), 2u);
  EXPECT_NEAR(parabola.at(feet[1]).x, std::sqrt(0.75), 1e-12);
}

TEST(Feet, NotWhereACubicStandsStill) {
  const Curve curve = bezier({0, 0}, {0, 0}, {1, 0}, {1, 0});  // no arms: slow at its ends
  const auto feet = perpendicular_feet(curve, {0.3, 1});
  ASSERT_EQ(feet.size(), 1u);
  EXPECT_NEAR(feet[0], 0.3, 1e-9);
  EXPECT_TRUE(tangent_places(curve, {0.3, 1}).empty());
}

TEST(Feet, StandSquareToTheWay) {
  EXPECT_TRUE(rc::check("feet are square", [] {
    const Curve curve = *any_curve();
    const Vec2 p = *any_place();
    for (const double s : perpendicular_feet(curve, p)) {
      const auto off_square = [&](Vec2 tangent) { return std::abs(dot(tangent, p - curve.at(s))); };
      RC_ASSERT(least_about(curve, s, off_square) < 1e-4);
    }
  }));
}

TEST(NearestPlace, IsNoFartherThanAnySample) {
  EXPECT_TRUE(rc::check("nothing is nearer", [] {
    const Curve curve = *any_curve();
    const Vec2 p = *any_place();
    const double least = distance(curve.at(nearest_place(curve, p)), p);
    for (int i = 0; i <= 100; ++i) RC_ASSERT(distance(curve.at(curve.length() * i / 100), p) >= least - 1e-9);
  }));
}

TEST(Tangents, OfACircle) {
  const auto found = tangent_places(circle({0, 0}, {1, 0}), {2, 0});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], pi / 3, 1e-14);
  EXPECT_NEAR(found[1], 5 * pi / 3, 1e-14);
  EXPECT_TRUE(tangent_places(circle({0, 0}, {1, 0}), {0.5, 0}).empty());
  EXPECT_TRUE(tangent_places(line({0, 0}, {1, 0}), {0.5, 1}).empty());
}

TEST(Tangents, OfAParabola) {
  const Curve parabola = bezier({0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1});
  const auto found = tangent_places(parabola, {0.25, 0});  // y = x^2 at 0 and at 1/2
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(parabola.at(found[1]).x, 0.5, 1e-12);
}

TEST(Tangents, RunThroughThePoint) {
  EXPECT_TRUE(rc::check("tangents pass through their point", [] {
    const Curve curve = *any_curve();
    const Vec2 p = *any_place();
    for (const double s : tangent_places(curve, p)) {
      const auto aside = [&](Vec2 tangent) { return std::abs(cross(tangent, p - curve.at(s))); };
      RC_ASSERT(least_about(curve, s, aside) < 1e-4);
    }
  }));
}

}  // namespace
}  // namespace toile
