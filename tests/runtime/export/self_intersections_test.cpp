#include "runtime/contact/self_intersections.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/runtime/export/draped_tube.hpp"

namespace toile {
namespace {

Cloth triangles(int vertices, const std::vector<std::array<int, 3>>& list) {
  Cloth cloth;
  cloth.vertex_count = vertices;
  for (const auto& vertices_of : list) cloth.triangles.push_back({.vertices = vertices_of, .edges = {}, .uv = {}});
  return cloth;
}

TEST(SelfIntersections, ACleanSurfaceHasNone) {
  const DrapedTube tube = draped_tube(6, 0.3);
  EXPECT_EQ(intersecting_triangle_pairs(tube.cloth, tube.drape.positions), 0);
}

TEST(SelfIntersections, CrossingTrianglesAreCountedOnce) {
  const Cloth cloth = triangles(6, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(intersecting_triangle_pairs(
                cloth, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1}, {0.3, 0.2, 1}, {0.2, 0.3, 1}}),
            1);
  EXPECT_EQ(intersecting_triangle_pairs(
                cloth, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0.1}, {0.3, 0.2, 1}, {0.2, 0.3, 1}}),
            0);
}

TEST(SelfIntersections, TouchingIsDecidedExactly) {
  const Cloth cloth = triangles(6, {{0, 1, 2}, {3, 4, 5}});
  const double ulp = std::numeric_limits<double>::denorm_min();
  const auto pairs = [&](double tip) {
    return intersecting_triangle_pairs(
        cloth, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, tip}, {0.3, 0.2, 1}, {0.2, 0.3, 1}});
  };
  EXPECT_EQ(pairs(0), 1);
  EXPECT_EQ(pairs(ulp), 0);
  EXPECT_EQ(pairs(-ulp), 1);
}

TEST(SelfIntersections, TrianglesWithOneCommonVertexCountWhenTheyMeetElsewhere) {
  const Cloth cloth = triangles(5, {{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(intersecting_triangle_pairs(cloth, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1}, {0.3, 0.3, -1}}), 1);
  EXPECT_EQ(intersecting_triangle_pairs(cloth, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.3, 0.3, 1}, {-0.3, -0.3, -1}}), 0);
}

TEST(SelfIntersections, NeighboursAlongAnEdgeDoNotCount) {
  const Cloth cloth = triangles(4, {{0, 1, 2}, {1, 0, 3}});
  EXPECT_EQ(intersecting_triangle_pairs(cloth, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.9, 0}}), 0);
}

TEST(SelfIntersections, ATubePushedThroughItselfCrossesInPairs) {
  DrapedTube tube = draped_tube();
  for (Vec3& p : tube.drape.positions) {
    if (p.z < -0.09) p.x = -p.x;
  }
  EXPECT_GT(intersecting_triangle_pairs(tube.cloth, tube.drape.positions), 0);
}

TEST(SelfIntersections, TrianglesWithoutAreaOrPlaceAreLeftOut) {
  const Cloth cloth = triangles(6, {{0, 1, 2}, {3, 4, 5}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(intersecting_triangle_pairs(cloth, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 0}, {0, 0, 1}}), 0);
  EXPECT_EQ(intersecting_triangle_pairs(cloth, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, -1}, {0, 0, 0}, {1, 0, 1}}),
            0);
}

}  // namespace
}  // namespace toile
