// Holes that are sewn or worn: divided like their partners, one line in the sewn surface.
#include <gtest/gtest.h>

#include "tests/compiler/mesh/checks.hpp"

namespace toile {
namespace {

using namespace test;  // NOLINT

/// A rectangle with a round hole, edge 4.
Piece holed(double radius) {
  Piece piece = rectangle("sheet", 0.5, 0.4);
  piece.holes.push_back({edge("neck.rim", circle({0.25, 0.2}, {0.25, 0.2 + radius}, false))});
  return piece;
}

TEST(Holes, AreDividedLikeWhatIsSewnToThem) {
  Garment g = garment("collar", {holed(0.1), rectangle("collar", 0.66, 0.05)});
  sew_chains(g, {along(1, 1)}, {against(1, 3)});
  sew_chains(g, {along(1, 0)}, {against(0, 4)});
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  expect_sound(mesh.p, g);
  expect_equal_fractions(mesh.p, g);
  expect_strict(mesh);
  EXPECT_EQ(mesh.s.topology.components, 1);
  EXPECT_EQ(mesh.s.topology.boundary_loops, 2);
  EXPECT_EQ(mesh.s.topology.euler, 0);
  EXPECT_TRUE(mesh.s.topology.orientable);
}

TEST(Holes, OfTwoPiecesAreSewnToEachOther) {
  Garment g = garment("cuff", {holed(0.1), holed(0.08)});
  sew_chains(g, {along(0, 4)}, {against(1, 4)});
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  expect_equal_fractions(mesh.p, g);
  expect_strict(mesh);
  EXPECT_EQ(mesh.s.topology.boundary_loops, 2);
  EXPECT_EQ(mesh.s.topology.euler, 0);
}

TEST(Holes, AreWornAsClosedLines) {
  Garment g = garment("poncho", {holed(0.1)});
  g.wears.push_back({{along(0, 4)}, "neck", true, 0, {}});
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  ASSERT_EQ(mesh.p.edge_nodes[0].size(), 5u);
  ASSERT_EQ(mesh.s.worn.size(), 1u);
  const SMesh::WornLine& worn = mesh.s.worn[0];
  EXPECT_TRUE(worn.closed);
  EXPECT_NEAR(worn.length, 2 * pi * 0.1, 1e-9);
  EXPECT_EQ(worn.vertices.size() + 1, mesh.p.edge_nodes[0][4].points.size());
  for (const int v : worn.vertices) {
    EXPECT_NEAR(distance(mesh.p.points[mesh.s.p_of_s[v][0]], Vec2{0.25, 0.2}), 0.1, 1e-12);
  }
}

}  // namespace
}  // namespace toile
