// Nodes along seams: the same fractions of arc length on both sides, and nothing else that pieces have in common.
#include <gtest/gtest.h>

#include "tests/compiler/mesh/checks.hpp"

namespace toile {
namespace {

using namespace test;  // NOLINT

TEST(Seams, DivideBothSidesInTheSameProportion) {
  Garment g =
      garment("cap and armhole", {rectangle("straight", 0.4, 0.2), disc("round", 0.12), gore("gore", 0.3, 0.2)});
  sew_chains(g, {along(0, 2)}, {against(2, 1)});
  sew_chains(g, {along(0, 0)}, {against(1, 0)});
  const PMesh mesh = make_pmesh(g, {});
  expect_sound(mesh, g);
  expect_equal_fractions(mesh, g);
}

TEST(Seams, GiveEveryCornerItsNodeOnTheOtherSide) {
  Garment g = garment("yoke", {rectangle("left", 0.1, 0.2), rectangle("middle", 0.23, 0.2),
                               rectangle("right", 0.07, 0.2), rectangle("yoke", 0.55, 0.1)});
  sew_chains(g, {along(0, 2), along(1, 2), along(2, 2)}, {against(3, 0)});
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  expect_equal_fractions(mesh.p, g);
  expect_strict(mesh);
  const auto at = fractions(mesh.p, g.seams[0].second);
  for (const double corner : {0.1 / 0.4, 0.33 / 0.4}) {
    EXPECT_TRUE(std::any_of(at.begin(), at.end(), [&](double f) { return std::abs(f - corner) < 1e-12; }));
  }
  EXPECT_EQ(mesh.s.topology.components, 1);
  EXPECT_EQ(mesh.s.topology.euler, 1 + 0);
}

TEST(Seams, CarryCornersFromPieceToPiece) {
  // The end of `a` in the middle of b's edge must reach c, which is sewn to b's other side by a seam of its own.
  Garment g = garment("chain", {rectangle("a", 0.1, 0.1), rectangle("a2", 0.2, 0.1), rectangle("b", 0.3, 0.1),
                                rectangle("c", 0.3, 0.1)});
  sew_chains(g, {along(0, 0), along(1, 0)}, {against(2, 0)});
  sew_chains(g, {along(3, 0)}, {along(2, 0)});
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  expect_equal_fractions(mesh.p, g);
  expect_strict(mesh);
}

TEST(Seams, LetCornersMeetThatAreMeantTo) {
  // Side seams 0.4 mm apart after easing: one node, no sliver.
  Garment g = garment("waist", {rectangle("a", 0.2, 0.1), rectangle("b", 0.3, 0.1), rectangle("c", 0.2004, 0.1),
                                rectangle("d", 0.3, 0.1)});
  sew_chains(g, {along(0, 0), along(1, 0)}, {against(3, 0), against(2, 0)});
  std::swap(g.seams[0].second[0], g.seams[0].second[1]);
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  expect_strict(mesh);
  const auto& nodes = mesh.p.edge_nodes[0][0];
  EXPECT_EQ(nodes.points.size(), mesh.p.edge_nodes[2][0].points.size());
  for (std::size_t i = 0; i + 1 < nodes.arc.size(); ++i) EXPECT_GT(nodes.arc[i + 1] - nodes.arc[i], 0.01);
}

TEST(Seams, TransferSplitsThatAThinPieceNeeds) {
  Garment g = garment("binding", {rectangle("cloth", 0.4, 0.3), rectangle("binding", 0.4, 0.004)});
  sew_chains(g, {along(0, 0)}, {against(1, 0)});
  const PMesh mesh = make_pmesh(g, {});
  expect_equal_fractions(mesh, g);
  EXPECT_GT(mesh.edge_nodes[0][0].points.size(), 45U);
  EXPECT_GE(angles(mesh).least, 20);
}

TEST(Seams, AreAllThatAPiecesMeshDependsOn) {
  const Garment skirt = flared_skirt();
  Garment more = skirt;
  more.pieces.push_back(rectangle("thin", 0.5, 0.003));
  more.pieces.push_back(sector("sharp", 0.4, 0.1));
  sew_chains(more, {along(2, 0)}, {along(3, 0)});
  const PMesh alone = make_pmesh(skirt, {}), together = make_pmesh(more, {});
  ASSERT_LE(alone.points.size(), together.points.size());
  EXPECT_TRUE(std::equal(alone.points.begin(), alone.points.end(), together.points.begin()));
  EXPECT_TRUE(std::equal(alone.triangles.begin(), alone.triangles.end(), together.triangles.begin()));
}

TEST(Seams, GiveTheSameBytesTwice) {
  const Garment g = flared_skirt();
  const SewnMesh a = sew(g, {}), b = sew(g, {});
  expect_cells_agree(g, a);
  EXPECT_EQ(emit(a.p, g), emit(b.p, g));
  EXPECT_EQ(emit(a.s, g), emit(b.s, g));
  EXPECT_EQ(emit(a.p, g).find("-0.0000"), std::string::npos);
}

TEST(Seams, ComeNearTheNumberOfTrianglesAskedFor) {
  const Garment thin = garment("straps", {rectangle("a", 0.6, 0.012), rectangle("b", 0.4, 0.02)});
  for (const Garment& g : {flared_skirt(), sphere_of_two_discs(), thin}) {
    for (const int wanted : {400, 1500, 4000}) {
      PMeshOptions options;
      options.target_edge = edge_for_triangles(g, wanted);
      const double found = static_cast<double>(make_pmesh(g, options).triangles.size());
      EXPECT_NEAR(found / wanted, 1, 0.1) << g.name;
    }
  }
}

TEST(WornLines, RunRoundTheWaistPastTheDarts) {
  const Garment g = flared_skirt();
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  ASSERT_EQ(mesh.s.worn.size(), 1U);
  const auto& line = mesh.s.worn[0];
  EXPECT_TRUE(line.closed);
  double length = 0;
  std::size_t sides = 0;
  for (const ChainLink& link : g.wears[0].chain) {
    length += g.pieces[link.edge.piece].edges[link.edge.edge].curve.length();
    sides += mesh.p.edge_nodes[link.edge.piece][link.edge.edge].points.size() - 1;
  }
  EXPECT_NEAR(line.length, length, 1e-12);
  EXPECT_EQ(line.vertices.size(), sides);
  EXPECT_TRUE(std::is_sorted(line.arc.begin(), line.arc.end(), std::less_equal<>()));
  EXPECT_EQ(line.arc.front(), 0);
  // Neighbours on the line are neighbours on the surface, the last and the first as well.
  for (std::size_t i = 0; i < line.vertices.size(); ++i) {
    std::array<int, 2> ends{line.vertices[i], line.vertices[(i + 1) % line.vertices.size()]};
    std::sort(ends.begin(), ends.end());
    EXPECT_TRUE(std::any_of(mesh.s.edges.begin(), mesh.s.edges.end(),
                            [&](const SMesh::Edge& e) { return e.vertices == ends && e.wings.size() == 1; }));
  }
}

TEST(WornLines, ThatDoNotCloseStayOpen) {
  Garment g = tube();
  g.wears.push_back({{along(0, 2)}, "neck", true, 0, {}});
  g.wears.push_back({{against(0, 3)}, "cord", false, 0, {}});
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  EXPECT_TRUE(mesh.s.worn[0].closed);
  EXPECT_FALSE(mesh.s.worn[1].closed);
  EXPECT_NEAR(mesh.s.worn[1].length, 0.3, 1e-12);
  EXPECT_EQ(mesh.s.worn[1].vertices.size(), mesh.p.edge_nodes[0][3].points.size());
}

}  // namespace
}  // namespace toile
