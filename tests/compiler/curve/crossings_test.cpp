// Where curves meet: crossing, touching, overlapping, sharing an end.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <numbers>

#include "compiler/curve/curve.hpp"

namespace toile {
namespace {

using std::numbers::pi;

void expect_point(const Crossing& crossing, Vec2 wanted) {
  EXPECT_NEAR(crossing.point.x, wanted.x, 1e-9);
  EXPECT_NEAR(crossing.point.y, wanted.y, 1e-9);
}

TEST(Crossings, LinesCrossOnce) {
  const auto found = crossings(line({0, 0}, {1, 1}), line({0, 1}, {1, 0}));
  ASSERT_EQ(found.size(), 1u);
  expect_point(found[0], {0.5, 0.5});
  EXPECT_NEAR(found[0].s_first, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(found[0].s_second, std::sqrt(0.5), 1e-12);
}

TEST(Crossings, LinesApartDoNot) {
  EXPECT_TRUE(crossings(line({0, 0}, {1, 1}), line({0, 1e-6}, {1, 1 + 1e-6})).empty());
  EXPECT_TRUE(crossings(line({0, 0}, {1, 0}), line({1.001, -1}, {1.001, 1})).empty());
}

TEST(Crossings, SharedEndIsNoCrossing) {
  EXPECT_TRUE(crossings(line({0, 0}, {1, 0}), line({1, 0}, {1, 1})).empty());
  EXPECT_TRUE(crossings(line({0, 0}, {1, 0}), line({1, 0}, {0.5, 1e-4})).empty());
  // A smooth join, and a cusp between an arc and its tangent.
  EXPECT_TRUE(crossings(line({-1, 0}, {0, 0}), arc_of_radius({0, 0}, {1, 1}, 1)).empty());
  EXPECT_TRUE(crossings(line({1, 0}, {0, 0}), arc_of_radius({0, 0}, {1, 1}, 1)).empty());
}

TEST(Crossings, EndOnTheOtherIsACrossing) {
  const auto found = crossings(line({0, 0}, {1, 0}), line({0.3, 0}, {0.3, 1}));
  ASSERT_EQ(found.size(), 1u);
  expect_point(found[0], {0.3, 0});
}

TEST(Crossings, LineAndCircleCrossTwice) {
  const auto found = crossings(line({-2, 0.5}, {2, 0.5}), circle({0, 0}, {1, 0}));
  ASSERT_EQ(found.size(), 2u);
  expect_point(found[0], {-std::sqrt(0.75), 0.5});
  expect_point(found[1], {std::sqrt(0.75), 0.5});
  EXPECT_NEAR(found[1].s_second, pi / 6, 1e-9);
}

TEST(Crossings, TangentLineTouchesOnce) {
  const auto found = crossings(line({-2, 1}, {2, 1}), circle({0, 0}, {1, 0}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].point.x, 0, 1e-4);
  EXPECT_NEAR(found[0].point.y, 1, 1e-8);
  EXPECT_TRUE(crossings(line({-2, 1 + 1e-7}, {2, 1 + 1e-7}), circle({0, 0}, {1, 0})).empty());
}

TEST(Crossings, TwoCubicsMeetNineTimes) {
  const Curve first = bezier({0, 0}, {0.333333, 3}, {0.666667, -2}, {1, 1});
  const Curve second = bezier({0, 0.0}, {3, 0.333333}, {-2, 0.666667}, {1, 1});
  const auto found = crossings(first, second);
  EXPECT_EQ(found.size(), 7u);  // Bezout's nine less the two shared ends
  for (const Crossing& c : found) EXPECT_LT(distance(first.at(c.s_first), second.at(c.s_second)), 2e-9);
}

TEST(Crossings, OverlapIsReported) {
  EXPECT_FALSE(crossings(line({0, 0}, {1, 0}), line({0.4, 0}, {2, 0})).empty());
  EXPECT_FALSE(crossings(line({0, 0}, {1, 0}), line({1, 0}, {0.5, 0})).empty());
  const Curve cubic = bezier({0, 0}, {0.3, 0.5}, {0.7, -0.5}, {1, 0.2});
  EXPECT_FALSE(crossings(cubic, cubic.part(0.1, 0.6)).empty());
  EXPECT_FALSE(crossings(circle({0, 0}, {1, 0}), arc_through({0, 1}, {-1, 0}, {0, -1})).empty());
}

TEST(SelfCrossings, LoopOfACubic) {
  const Curve loop = bezier({0, 0}, {1.5, 1}, {-0.5, 1}, {1, 0});
  const auto found = self_crossings(loop);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].point.x, 0.5, 1e-9);
  EXPECT_LT(distance(loop.at(found[0].s_first), loop.at(found[0].s_second)), 1e-9);
  EXPECT_TRUE(self_crossings(bezier({0, 0}, {0.2, 1}, {0.8, 1}, {1, 0})).empty());
}

TEST(SelfCrossings, ClosedOutline) {
  const auto outline = [](std::initializer_list<Vec2> corners) {
    std::vector<Curve> edges;
    Vec2 before = *(corners.end() - 1);
    for (const Vec2 corner : corners) {
      edges.push_back(line(before, corner));
      before = corner;
    }
    return join(edges);
  };
  EXPECT_TRUE(self_crossings(outline({{0, 0}, {1, 0}, {1, 1}, {0, 1}})).empty());
  EXPECT_EQ(self_crossings(outline({{0, 0}, {1, 1}, {1, 0}, {0, 1}})).size(), 1u);
  EXPECT_TRUE(self_crossings(circle({0, 0}, {0.1, 0})).empty());
}

TEST(SelfCrossings, SpikeThatTurnsBackOnItself) {
  EXPECT_FALSE(self_crossings(join({line({0, 0}, {1, 0}), line({1, 0}, {0.5, 0}), line({0.5, 0}, {0, 1})})).empty());
}

TEST(CrossingsProperties, EveryCrossingLiesOnBothCurvesAndLinesAreFound) {
  const auto place = [] {
    const auto coordinate = rc::gen::map(rc::gen::inRange(-500, 501), [](int mm) { return mm / 1000.0; });
    return rc::gen::construct<Vec2>(coordinate, coordinate);
  };
  EXPECT_TRUE(rc::check([&] {
    const Curve cubic = bezier(*place(), *place(), *place(), *place());
    const Vec2 a = *place(), b = *place();
    RC_PRE(distance(a, b) > 0.01);
    const auto found = crossings(line(a, b), cubic);
    for (const Crossing& c : found) RC_ASSERT(distance(c.point, cubic.at(c.s_second)) < 1e-8);
    // The cubic changes from one side of the whole line to the other as often as it meets it, counted without the
    // crossing code.
    const auto& p = std::get<BezierSegment>(cubic.segments()[0]);
    int changes = 0;
    double before = 0, nearest = 1;
    for (int i = 0; i <= 4000; ++i) {
      const double t = i / 4000.0, u = 1 - t;
      const Vec2 q = u * u * u * p.p0 + 3 * u * u * t * p.p1 + 3 * u * t * t * p.p2 + t * t * t * p.p3;
      const double along = dot(q - a, b - a) / dot(b - a, b - a);
      const double side = cross(b - a, q - a);
      if (before * side < 0 && along > 0.01 && along < 0.99) ++changes;
      if (along > -0.02 && along < 0.02) nearest = std::min(nearest, std::abs(side));
      if (along > 0.98 && along < 1.02) nearest = std::min(nearest, std::abs(side));
      before = side;
    }
    RC_PRE(nearest > 0.005);
    RC_ASSERT(static_cast<int>(found.size()) >= changes);
  }));
}

}  // namespace
}  // namespace toile
