// The clearance that contact sees: smooth where the surface is not, and near the surface all the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "runtime/body/body.hpp"
#include "tests/runtime/body/sample_form.hpp"

namespace toile {
namespace {

std::array<Vec3, 3> axes(double length) {
  return {Vec3{length, 0, 0}, Vec3{0, length, 0}, Vec3{0, 0, length}};
}

double component(Vec3 v, std::size_t k) {
  return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

/// Places within a millimetre of the surface, at corners, on edges and on faces.
std::vector<Vec3> places_near(const Body::Surface& surface, int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1), shift(-0.0006, 0.0006);
  std::vector<Vec3> places;
  for (int i = 0; i < count; ++i) {
    const auto& [a, b, c] = surface.triangles[random() % surface.triangles.size()];
    const double u = share(random), v = i % 3 == 0 ? 0 : (1 - u) * share(random);
    const Vec3 on =
        surface.points[a] + u * (surface.points[b] - surface.points[a]) + v * (surface.points[c] - surface.points[a]);
    places.push_back(on + Vec3{shift(random), shift(random), shift(random)});
  }
  return places;
}

TEST(Clearance, DerivativesAreThoseOfTheDistance) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  constexpr double step = 1e-7;
  for (const Vec3& p : places_near(body->surface(), 400)) {
    const auto here = body->clearance(p, 0.01);
    ASSERT_TRUE(here);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ahead = body->clearance(p + axes(step)[k], 0.01), behind = body->clearance(p - axes(step)[k], 0.01);
      EXPECT_NEAR((ahead->distance - behind->distance) / (2 * step), component(here->gradient, k), 1e-5);
    }
  }
}

TEST(Clearance, SecondDerivativesAreThoseOfTheGradient) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  constexpr double step = 1e-7;
  int kinks = 0, entries = 0;
  for (const Vec3& p : places_near(body->surface(), 400)) {
    const auto here = body->clearance(p, 0.01);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ahead = body->clearance(p + axes(step)[k], 0.01), behind = body->clearance(p - axes(step)[k], 0.01);
      const Vec3 slope = (ahead->gradient - behind->gradient) / (2 * step);
      // Where a triangle's nearest feature changes within the step the second derivative jumps: that is rare.
      kinks += norm(slope - here->hessian[k]) > 1e-3 * std::max(norm(here->hessian[k]), 1.0);
      ++entries;
    }
  }
  EXPECT_LT(kinks, entries / 100);
}

TEST(Clearance, TurnsWithoutJumpsWhereFacetsMeet) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  const BodyLine* waist = body->line("waist");
  ASSERT_NE(waist, nullptr);
  double most = 0, most_of_facets = 0;
  for (std::size_t i = 0; i + 1 < waist->points.size(); ++i) {
    const Vec3 from = waist->points[i], way = waist->points[i + 1] - from;
    const int steps = static_cast<int>(std::ceil(norm(way) / 2e-5));
    for (int s = 0; s < steps; ++s) {
      const Vec3 here = from + (1.0 * s / steps) * way, next = from + (1.0 * (s + 1) / steps) * way;
      most = std::max(most, norm(body->clearance(next, 0.01)->gradient - body->clearance(here, 0.01)->gradient));
      most_of_facets =
          std::max(most_of_facets, norm(body->nearest(next, 0.01)->normal - body->nearest(here, 0.01)->normal));
    }
  }
  EXPECT_LT(most, most_of_facets / 10);  // in steps of 0.02 mm
}

TEST(Clearance, LiesWithinTenthsOfAMillimetreOfTheSurface) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  double mean = 0, share_far = 0;
  const std::vector<Vec3> places = places_near(body->surface(), 3000);
  for (const Vec3& p : places) {
    const double off = std::abs(body->clearance(p, 0.01)->distance - body->nearest(p, 0.01)->distance);
    mean += off / static_cast<double>(places.size());
    share_far += (off > 3e-4) / static_cast<double>(places.size());
  }
  EXPECT_LT(mean, 1e-4);
  EXPECT_LT(share_far, 0.03);  // at the rims of the form's ends and in its armpits
}

TEST(Clearance, OfARoundBodyIsItsDistance) {
  const auto ball = Body::make(body_of(SphereSpec{0.1, 1}), nullptr);
  ASSERT_TRUE(ball);
  const Vec3 p{0.06, -0.05, 1.07};
  EXPECT_DOUBLE_EQ(ball->clearance(p, 1)->distance, ball->nearest(p, 1)->distance);
}

}  // namespace
}  // namespace toile
