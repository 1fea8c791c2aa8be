#include "runtime/export/split_surface.hpp"

#include <gtest/gtest.h>

#include "tests/runtime/export/draped_tube.hpp"

namespace toile {
namespace {

TEST(SplitSurface, ShadingRunsSmoothlyAcrossASeam) {
  const DrapedTube tube = draped_tube();
  const SplitSurface surface = split_surface(tube.mesh, tube.drape.positions);
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const Vec3 p = surface.positions[i];
    EXPECT_GT(dot(surface.normals[i], normalized(Vec3{p.x, p.y, 0})), 0.99);
    EXPECT_NEAR(norm(surface.normals[i]), 1, 1e-12);
  }
}

/// A strip of squares whose ends are sewn after half a turn.
SewnMesh moebius_strip(int squares, std::vector<Vec3>& positions) {
  SewnMesh mesh;
  mesh.p.warp_of_piece = {{1, 0}};
  for (int column = 0; column <= squares; ++column) {
    for (int row = 0; row < 2; ++row) {
      mesh.p.points.push_back({0.1 * column, 0.1 * row});
      mesh.p.piece_of_point.push_back(0);
      const double angle = 2 * std::numbers::pi * column / squares;
      const double across = 0.1 * (row - 0.5);
      const double reach = 0.5 + across * std::cos(angle / 2);
      if (column < squares) {
        positions.push_back({reach * std::cos(angle), reach * std::sin(angle), across * std::sin(angle / 2)});
      }
    }
  }
  for (int a = 0; a < 2 * squares; a += 2) {
    mesh.p.triangles.push_back({a, a + 2, a + 3});
    mesh.p.triangles.push_back({a, a + 3, a + 1});
    mesh.p.piece_of_triangle.insert(mesh.p.piece_of_triangle.end(), 2, 0);
  }
  mesh.s = sewn(mesh.p, {{0, 2 * squares + 1}, {1, 2 * squares}});
  return mesh;
}

TEST(SplitSurface, AtTheSeamOfAMoebiusStripEachSideKeepsItsRightSide) {
  std::vector<Vec3> positions;
  const SewnMesh mesh = moebius_strip(24, positions);
  const SplitSurface surface = split_surface(mesh, positions);
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3 p = surface.positions[static_cast<std::size_t>(a)];
    const Vec3 face =
        cross(surface.positions[static_cast<std::size_t>(b)] - p, surface.positions[static_cast<std::size_t>(c)] - p);
    for (const int corner : {a, b, c}) {
      EXPECT_GT(dot(normalized(face), surface.normals[static_cast<std::size_t>(corner)]), 0.9);
    }
  }
  EXPECT_LT(dot(surface.normals[0], surface.normals[49]), -0.99);  // the same sewn vertex from its two sides
}

TEST(SplitSurface, ShadingBreaksWhereThreeSheetsMeet) {
  SewnMesh mesh;
  mesh.p.warp_of_piece.assign(3, {1, 0});
  for (int piece = 0; piece < 3; ++piece) {
    mesh.p.points.insert(mesh.p.points.end(), {{0, 0}, {0.1, 0}, {0.05, 0.1}});
    mesh.p.piece_of_point.insert(mesh.p.piece_of_point.end(), 3, piece);
    mesh.p.triangles.push_back({3 * piece, 3 * piece + 1, 3 * piece + 2});
    mesh.p.piece_of_triangle.push_back(piece);
  }
  mesh.s = sewn(mesh.p, {{0, 3}, {1, 4}, {0, 6}, {1, 7}});
  const SplitSurface surface =
      split_surface(mesh, {{0, 0, 0}, {0.1, 0, 0}, {0.05, 0.1, 0}, {0.05, 0, 0.1}, {0.05, -0.1, 0}});
  EXPECT_NEAR(surface.normals[0].z, 1, 1e-12);
  EXPECT_NEAR(surface.normals[3].y, -1, 1e-12);
  EXPECT_NEAR(surface.normals[6].z, -1, 1e-12);
}

}  // namespace
}  // namespace toile
