#include "runtime/render/camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr View kViews[] = {View::Front, View::Back, View::Left, View::Right, View::Above, View::ThreeQuarter};

std::vector<Vec3> helix() {
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i) points.push_back({0.3 * std::cos(0.2 * i), 0.2 * std::sin(0.2 * i), 0.006 * i});
  return points;
}

TEST(Camera, FramesEverythingTightlyInEveryView) {
  constexpr double kMargin = 0.07;
  for (const Viewport viewport : {Viewport{0, 0, 800, 800}, Viewport{0, 0, 650, 800}, Viewport{40, 10, 900, 200}}) {
    for (const View view : kViews) {
      const Camera camera(aim(view), viewport, helix(), kMargin);
      Vec2 low{1e9, 1e9};
      Vec2 high{-1e9, -1e9};
      for (const Vec3& p : helix()) {
        const Vec2 seen = camera.project(p);
        low = {std::min(low.x, seen.x), std::min(low.y, seen.y)};
        high = {std::max(high.x, seen.x), std::max(high.y, seen.y)};
      }
      const double left = low.x - viewport.left - kMargin * viewport.width;
      const double right = viewport.left + (1 - kMargin) * viewport.width - high.x;
      const double above = low.y - viewport.top - kMargin * viewport.height;
      const double below = viewport.top + (1 - kMargin) * viewport.height - high.y;
      EXPECT_GE(std::min({left, right, above, below}), -1e-6);
      EXPECT_LE(std::min({left, right, above, below}), 1e-6) << "one direction fills the picture";
    }
  }
}

TEST(Camera, LooksAtTheWearerFromWhereTheViewSays) {
  const Vec3 front{0, -1, 0.5};
  const Vec3 left_hand{1, 0, 0.5};
  const std::vector<Vec3> points{front, -front, left_hand, -left_hand, {0, 0, 1}};
  const auto seen_at = [&](View view, Vec3 p) { return Camera(aim(view), {0, 0, 100, 100}, points, 0.1).project(p); };
  EXPECT_GT(dot(aim(View::Front).forward, {0, 1, 0}), 0.9);
  EXPECT_GT(dot(aim(View::Left).forward, {-1, 0, 0}), 0.9);
  EXPECT_GT(seen_at(View::Front, left_hand).x, 60);
  EXPECT_LT(seen_at(View::Back, left_hand).x, 40);
  EXPECT_LT(seen_at(View::Left, front).x, 40);
  EXPECT_GT(seen_at(View::Right, front).x, 60);
  EXPECT_GT(seen_at(View::Above, front).y, 60) << "the front is at the bottom";
  EXPECT_LT(seen_at(View::Front, {0, 0, 1}).y, 40) << "up is up";
}

TEST(Camera, RaysAndProjectionAgree) {
  const Camera camera(aim(View::ThreeQuarter), {0, 0, 300, 200}, helix(), 0.05);
  const Ray ray = camera.ray(70, 150);
  EXPECT_NEAR(norm(ray.direction), 1, 1e-12);
  const Vec2 back = camera.project(ray.origin + 2.5 * ray.direction);
  EXPECT_NEAR(back.x, 70, 1e-9);
  EXPECT_NEAR(back.y, 150, 1e-9);
}

TEST(Camera, StandsClearOfASinglePointAndOfNothing) {
  for (const std::vector<Vec3>& points : {std::vector<Vec3>{}, std::vector<Vec3>{{0.2, 0.1, 0}}}) {
    const Ray ray = Camera(aim(View::Front), {0, 0, 10, 10}, points, 0.1).ray(5, 5);
    EXPECT_TRUE(std::isfinite(ray.origin.x + ray.direction.y));
    for (const Vec3& p : points) EXPECT_GT(distance(ray.origin, p), 0);
  }
}

}  // namespace
}  // namespace toile
