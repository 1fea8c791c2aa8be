#include "runtime/render/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/runtime/render/scenes.hpp"

namespace toile {
namespace {

constexpr double kSmooth = std::numbers::pi;

Surface surface(std::vector<Vec3> points, std::vector<PerCorner<int>> triangles, double crease) {
  Surface result{std::move(points), std::move(triangles), {}, {}, {}, {}};
  result.normals = corner_normals(result.points, result.triangles, EdgeTable(result.triangles), crease);
  return result;
}

Surface ball(int rings) {
  const test::SphereBody body({0, 0, 0}, 1, rings);
  return surface(body.surface().points, body.surface().triangles, kSmooth);
}

/// A strip with one half twist; the last column is sewn to the first upside down.
Surface moebius(int columns) {
  std::vector<Vec3> points;
  std::vector<PerCorner<int>> triangles;
  for (int i = 0; i < columns; ++i) {
    const double a = 2 * std::numbers::pi * i / columns;
    for (const double s : {-0.3, 0.3}) {
      const double r = 1 + s * std::cos(a / 2);
      points.push_back({r * std::cos(a), r * std::sin(a), s * std::sin(a / 2)});
    }
  }
  for (int i = 0; i < columns; ++i) {
    const bool last = i == columns - 1;
    const int a = 2 * i;
    const int b = 2 * i + 1;
    const int c = last ? 1 : 2 * i + 2;
    const int d = last ? 0 : 2 * i + 3;
    triangles.push_back({a, c, b});
    triangles.push_back({b, c, d});
  }
  return surface(points, triangles, kSmooth);
}

TEST(CornerNormals, AreRadialOnABall) {
  const Surface s = ball(24);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_GT(dot(s.normals[t][c], s.points[static_cast<std::size_t>(s.triangles[t][c])]), 0.995);
    }
  }
}

TEST(CornerNormals, AreSmoothOnAOneSidedStrip) {
  const Surface s = moebius(60);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const Vec3 a = s.points[static_cast<std::size_t>(s.triangles[t][0])];
    const Vec3 flat = normalized(cross(s.points[static_cast<std::size_t>(s.triangles[t][1])] - a,
                                       s.points[static_cast<std::size_t>(s.triangles[t][2])] - a));
    for (const Vec3& normal : s.normals[t]) EXPECT_GT(dot(normal, flat), 0.95);
  }
}

TEST(CornerNormals, StopAtACrease) {
  // A roof: two squares at right angles along the y axis.
  const std::vector<Vec3> points{{0, 0, 1}, {0, 1, 1}, {-1, 0, 0}, {-1, 1, 0}, {1, 0, 0}, {1, 1, 0}};
  const std::vector<PerCorner<int>> triangles{{2, 0, 3}, {3, 0, 1}, {0, 4, 1}, {1, 4, 5}};
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(surface(points, triangles, 1.0).normals[0][1].x, -half, 1e-12);
  // Two triangles of the left slope and one of the right.
  EXPECT_NEAR(surface(points, triangles, 2.0).normals[0][1].x, -1 / std::sqrt(10.0), 1e-12);
}

TEST(Divided, ComesCloserToTheSmoothSurfaceWithoutMovingItsPoints) {
  const Surface coarse = ball(8);
  const Surface fine = divided(coarse, kSmooth);
  ASSERT_EQ(fine.triangles.size(), 4 * coarse.triangles.size());
  // Closed stays closed: vertices - edges + triangles = 2.
  EXPECT_EQ(fine.points.size() + fine.triangles.size() - EdgeTable(fine.triangles).vertices.size(), 2u);
  for (std::size_t i = 0; i < coarse.points.size(); ++i) EXPECT_EQ(fine.points[i], coarse.points[i]);
  for (std::size_t i = coarse.points.size(); i < fine.points.size(); ++i) {
    EXPECT_NEAR(norm(fine.points[i]), 1, 0.008);  // the chords' middles are off by up to 0.04
  }
}

TEST(Divided, RoundsAFreeEdgeAndKeepsItsCorners) {
  // A fan: a disc of twelve sectors.
  std::vector<Vec3> points{{0, 0, 0}};
  std::vector<PerCorner<int>> triangles;
  for (int i = 0; i < 12; ++i) {
    const double a = std::numbers::pi / 6 * i;
    points.push_back({std::cos(a), std::sin(a), 0});
    triangles.push_back({0, 1 + i, 1 + (i + 1) % 12});
  }
  const Surface disc = divided(surface(points, triangles, kSmooth), kSmooth);
  for (const Vec3& p : disc.points) {
    if (norm(p) < 0.8) continue;  // on a spoke
    EXPECT_NEAR(norm(p), 1, 0.003);
  }
  const Surface square =
      divided(surface({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, kSmooth), kSmooth);
  for (const Vec3& p : square.points) {
    EXPECT_NEAR(std::max(std::abs(p.x - 0.5), std::abs(p.y - 0.5)), norm(p - Vec3{0.5, 0.5, 0}) < 0.1 ? 0 : 0.5, 1e-12);
  }
}

TEST(Divided, SurvivesWhatIsNoSurface) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  // Three triangles on one edge, a needle and a triangle twice.
  const Surface odd = surface(points, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {2, 2, 3}, {0, 1, 2}}, kSmooth);
  for (const Vec3& p : divided(odd, kSmooth).points) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  EXPECT_TRUE(divided(Surface{}, kSmooth).triangles.empty());
}

}  // namespace
}  // namespace toile
