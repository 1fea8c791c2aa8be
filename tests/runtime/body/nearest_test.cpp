// Nearest points: against trying every triangle, and against closed forms for the round shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "runtime/body/body.hpp"
#include "runtime/body/closest_point.hpp"
#include "runtime/body/manifold.hpp"
#include "tests/runtime/body/sample_form.hpp"

namespace toile {
namespace {

double least_distance(const Body::Surface& surface, Vec3 p) {
  double least = 1e300;
  for (const auto& [a, b, c] : surface.triangles) {
    least = std::min(
        least, distance(p, closest_on_triangle(p, surface.points[a], surface.points[b], surface.points[c]).point));
  }
  return least;
}

std::vector<Vec3> points_about(const Body::Surface& surface, double spread, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-spread, spread);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const Vec3 p = surface.points[random() % surface.points.size()];
    points.push_back(p + Vec3{shift(random), shift(random), shift(random)});
  }
  return points;
}

TEST(Nearest, AgreesWithTryingEveryTriangle) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  for (const Vec3& p : points_about(body->surface(), 0.1, 300, 1)) {
    const double expected = least_distance(body->surface(), p);
    const auto found = body->nearest(p, 1);
    ASSERT_TRUE(found);
    EXPECT_NEAR(std::abs(found->distance), expected, 1e-12);
    EXPECT_NEAR(distance(p, found->point), expected, 1e-12);
    EXPECT_NEAR(norm(found->normal), 1, 1e-12);
    EXPECT_NEAR(norm(found->point + found->distance * found->normal - p), 0, 1e-9);
  }
}

TEST(Nearest, DoesNotDependOnTheReach) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  for (const Vec3& p : points_about(body->surface(), 0.03, 2000, 2)) {
    const auto far = body->nearest(p, 10);
    ASSERT_TRUE(far);
    for (const double reach : {0.0, 0.0005, 0.01}) {
      const auto near = body->nearest(p, reach);
      ASSERT_EQ(near.has_value(), far->distance <= reach);
      if (!near) continue;
      EXPECT_EQ(near->point, far->point);
      EXPECT_EQ(near->normal, far->normal);
      EXPECT_EQ(near->triangle, far->triangle);
    }
  }
}

TEST(Nearest, FindsDeepPointsWithoutAnyReachAndNothingFarAway) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  const auto deep = body->nearest({0, 0, 1.0}, 0);
  ASSERT_TRUE(deep);
  EXPECT_LT(deep->distance, -0.05);
  EXPECT_FALSE(body->nearest({2, 2, 2}, 0.5));
  EXPECT_FALSE(body->nearest({0, 0, 0.3}, 0.01));  // between the legs
  EXPECT_FALSE(body->nearest({std::nan(""), 0, 0}, 1));
}

// Walking round the hip, the normal turns with the way and never leaps.
TEST(Nearest, NormalDoesNotJumpAcrossEdges) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  Vec3 before;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 4000;
    const auto found = body->nearest({0.2 * std::sin(angle), -0.2 * std::cos(angle), 0.82}, 1);
    ASSERT_TRUE(found);
    if (i > 0) {
      EXPECT_LT(distance(found->normal, before), 0.02);
    }
    before = found->normal;
  }
}

// The rounded solids' own distance: of a core grown by the rounding.
double exact_disc(Vec3 p, double radius, double thickness, double height) {
  const double r = thickness / 2;
  const double beside = std::max(std::hypot(p.x, p.y) - (radius - r), 0.0);
  return std::hypot(beside, p.z - (height - r)) - r;
}

TEST(RoundShapes, DistancesAreExact) {
  const auto ball = Body::make(body_of(SphereSpec{0.15, 0.8}), nullptr);
  const auto plate = Body::make(body_of(DiscSpec{0.09, 0.01, 1.0}), nullptr);
  ASSERT_TRUE(ball && plate);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> spread(-0.2, 0.2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 q{spread(random), spread(random), spread(random)};
    const auto on_ball = ball->nearest(q + Vec3{0, 0, 0.8}, 1);
    ASSERT_TRUE(on_ball);
    EXPECT_NEAR(on_ball->distance, norm(q) - 0.15, 1e-12);
    EXPECT_NEAR(distance(on_ball->normal, normalized(q)), 0, 1e-9);
    const auto on_plate = plate->nearest(q + Vec3{0, 0, 1}, 1);
    ASSERT_TRUE(on_plate);
    EXPECT_NEAR(on_plate->distance, exact_disc(q + Vec3{0, 0, 1}, 0.09, 0.01, 1.0), 1e-12);
  }
  const auto board = Body::make(body_of(BoxSpec{0.4, 0.3, 0.2, 0.9}), nullptr);
  ASSERT_TRUE(board);
  EXPECT_NEAR(board->nearest({0, 0, 0.95}, 1)->distance, 0.05, 1e-12);
  EXPECT_NEAR(board->nearest({0.1, 0.05, 0.85}, 0)->distance, -0.05, 1e-12);
  EXPECT_NEAR(board->nearest({0.25, 0, 0.8}, 1)->distance, 0.05, 1e-12);
  const auto floor = Body::make(body_of(PlaneSpec{0.1}), nullptr);
  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->nearest({3, 4, 0.08}, 0)->distance, -0.02, 1e-15);
  EXPECT_FALSE(floor->nearest({3, 4, 0.2}, 0.05));
}

TEST(RoundShapes, TrianglesLieOnThem) {
  const std::vector<decltype(BodySpec::shape)> shapes{SphereSpec{0.15, 0.15}, CylinderSpec{0.1, 0.4, 0.5, true},
                                                      CylinderSpec{0.1, 0.4, 0.5, false}, DiscSpec{0.09, 0.004, 1.0},
                                                      BoxSpec{0.4, 0.3, 0.2, 0.9}};
  const double pi = 3.14159265358979;
  const std::vector<double> volumes{4 * pi / 3 * std::pow(0.15, 3), pi * 0.01 * 0.4, pi * 0.01 * 0.4,
                                    pi * 0.0081 * 0.004, 0.024};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto body = Body::make(body_of(shapes[i]), nullptr);
    ASSERT_TRUE(body);
    EXPECT_EQ(manifold_fault(body->surface()), "") << i;
    EXPECT_NEAR(signed_volume(body->surface()) / volumes[i], 1, 0.02) << i;
    for (const Vec3& p : body->surface().points) EXPECT_NEAR(body->nearest(p, 1)->distance, 0, 1e-12) << i;
  }
}

TEST(RoundShapes, LinesAndTops) {
  const auto upright = Body::make(body_of(CylinderSpec{0.1, 0.4, 0.5, true}), nullptr);
  ASSERT_TRUE(upright);
  const BodyLine* middle = upright->line("middle");
  ASSERT_NE(middle, nullptr);
  EXPECT_NEAR(middle->girth, 2 * 3.14159265358979 * 0.1, 1e-4);
  EXPECT_NEAR(middle->points[0].y, -0.1, 1e-12);
  EXPECT_GT(middle->points[1].x, 0);  // from the front to the wearer's left
  EXPECT_NEAR(upright->top().z, 0.7, 1e-12);
  std::string error;
  EXPECT_FALSE(Body::make(body_of(SphereSpec{-1, 0}), &error));
  EXPECT_FALSE(error.empty());
}

}  // namespace
}  // namespace toile
