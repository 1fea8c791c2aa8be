#include "runtime/report/projection.hpp"

#include <gtest/gtest.h>

#include "tests/runtime/export/draped_tube.hpp"

namespace toile {
namespace {

Cloth two_triangles() {
  Cloth cloth;
  cloth.vertex_count = 4;
  cloth.triangles.push_back({.vertices = {0, 1, 2}, .edges = {}, .uv = {}});
  cloth.triangles.push_back({.vertices = {0, 2, 3}, .edges = {}, .uv = {}});
  return cloth;
}

TEST(ProjectedArea, OfALevelAndOfATiltedSquare) {
  EXPECT_NEAR(projected_area(two_triangles(), {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}), 1, 1e-12);
  EXPECT_NEAR(projected_area(two_triangles(), {{0, 0, 0}, {0.5, 0, 3}, {0.5, 1, 3}, {0, 1, 0}}), 0.5, 1e-12);
}

TEST(ProjectedArea, CountsWhatLiesDoubleOnce) {
  // Folded over its diagonal: both triangles lie on each other.
  EXPECT_NEAR(projected_area(two_triangles(), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0.1}}), 0.5, 1e-6);
}

TEST(ProjectedArea, OfAnUprightSheetIsNothing) {
  EXPECT_NEAR(projected_area(two_triangles(), {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}), 0, 1e-12);
  EXPECT_NEAR(projected_area(two_triangles(), {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}), 0, 1e-12);
}

TEST(ProjectedArea, OfADiscConvergesToThatOfItsPolygon) {
  constexpr int kSides = 90;
  Cloth cloth;
  cloth.vertex_count = kSides + 1;
  std::vector<Vec3> positions{{0, 0, 0}};
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    positions.push_back({0.15 * std::cos(angle), 0.15 * std::sin(angle), 0});
    cloth.triangles.push_back({.vertices = {0, 1 + i, 1 + (i + 1) % kSides}, .edges = {}, .uv = {}});
  }
  const double exact = kSides * 0.5 * 0.15 * 0.15 * std::sin(2 * std::numbers::pi / kSides);
  EXPECT_NEAR(projected_area(cloth, positions), exact, 1e-5 * exact);
}

}  // namespace
}  // namespace toile
