// Classical surfaces sewn from flat pieces: exact topology at any fineness, and always a strict complex.
#include <gtest/gtest.h>

#include "tests/compiler/mesh/checks.hpp"

namespace toile {
namespace {

using namespace test;  // NOLINT

struct Surface {
  const char* name;
  Garment garment;
  int components, loops, euler;
  bool orientable;
};

Garment t_seam() {
  Garment g = garment("t", {rectangle("a", 0.2, 0.2), rectangle("b", 0.2, 0.2), rectangle("c", 0.2, 0.2)});
  sew_chains(g, {along(0, 0)}, {against(1, 0)});
  sew_chains(g, {along(0, 0)}, {along(2, 0)});
  return g;
}

std::vector<Surface> surfaces() {
  Garment purse = garment("purse", {rectangle("cloth", 0.2, 0.1)});
  sew_chains(purse, {along(0, 0)}, {along(0, 0)});
  Garment zipped = garment("zipped", {rectangle("cloth", 0.2, 0.1)});
  sew_chains(zipped, {along(0, 0)}, {against(0, 0)});
  Garment football = garment("football", {gore("a", 0.1, 0.3), gore("b", 0.1, 0.3)});
  sew_chains(football, {along(0, 1)}, {against(1, 2)});
  sew_chains(football, {along(1, 1)}, {against(0, 2)});
  Garment pillow = football;
  sew_chains(pillow, {along(0, 0)}, {against(1, 0)});
  return {{"tube", tube(), 1, 2, 0, true},
          {"narrow tube", tube(0.005, 0.3), 1, 2, 0, true},
          {"wide short tube", tube(0.6, 0.004), 1, 2, 0, true},
          {"cone 20", cone(20 * pi / 180), 1, 1, 1, true},
          {"cone 90", cone(pi / 2), 1, 1, 1, true},
          {"cone 200", cone(200 * pi / 180), 1, 1, 1, true},
          {"cap of six", cap(6), 1, 1, 1, true},
          {"cap of three", cap(3), 1, 1, 1, true},
          {"football", football, 1, 1, 1, true},
          {"pillow", pillow, 1, 0, 2, true},
          {"torus", torus(), 1, 0, 0, true},
          {"moebius strip", moebius_strip(), 1, 1, 0, false},
          {"klein bottle", klein_bottle(), 1, 0, 0, false},
          {"projective plane", projective_plane(), 1, 0, 1, false},
          {"sphere of two discs", sphere_of_two_discs(), 1, 0, 2, true},
          {"an edge sewn to itself as it is", purse, 1, 1, 1, true},
          {"an edge folded and sewn", zipped, 1, 1, 1, true},
          {"two pieces apart", garment("apart", {disc("a", 0.1), disc("b", 0.1)}), 2, 2, 2, true},
          {"skirt", flared_skirt(), 1, 2, 0, true}};
}

TEST(Surfaces, HaveTheirTopologyAtAnyFineness) {
  for (const Surface& surface : surfaces()) {
    for (const double edge : {1.0, 0.1, 0.03, 0.011}) {
      SCOPED_TRACE(testing::Message() << surface.name << " at " << edge * 1000 << " mm");
      PMeshOptions options;
      options.target_edge = edge;
      const SewnMesh mesh = sew(surface.garment, options);
      expect_cells_agree(surface.garment, mesh);
      expect_sound(mesh.p, surface.garment);
      expect_strict(mesh);
      expect_consistent(mesh);
      const Topology& t = mesh.s.topology;
      EXPECT_EQ(t.components, surface.components);
      EXPECT_EQ(t.boundary_loops, surface.loops);
      EXPECT_EQ(t.euler, surface.euler);
      EXPECT_EQ(t.euler, t.vertices - t.edges + t.triangles);
      EXPECT_EQ(t.orientable, surface.orientable);
      EXPECT_TRUE(t.manifold);
      EXPECT_LT(t.triangles, 15000);
    }
  }
}

TEST(Surfaces, AreTheSameInAnyOrderOfSewing) {
  Garment g = flared_skirt();
  const SewnMesh one = sew(g, {});
  expect_cells_agree(g, one);
  std::reverse(g.seams.begin(), g.seams.end());
  for (Seam& seam : g.seams) std::swap(seam.first, seam.second);
  const SewnMesh other = sew(g, {});
  expect_cells_agree(g, other);
  EXPECT_EQ(one.s.triangles, other.s.triangles);
  EXPECT_EQ(one.s.s_of_p, other.s.s_of_p);
  EXPECT_EQ(one.p.points, other.p.points);
}

TEST(Surfaces, CarryThreeSheetsAtATSeam) {
  const Garment g = t_seam();
  PMeshOptions options;
  options.target_edge = 0.03;
  const SewnMesh mesh = sew(g, options);
  expect_cells_agree(g, mesh);
  expect_strict(mesh);
  expect_consistent(mesh);
  EXPECT_FALSE(mesh.s.topology.manifold);
  EXPECT_EQ(mesh.s.topology.components, 1);
  EXPECT_EQ(mesh.s.topology.euler, 1);
  int triple = 0;
  for (const auto& e : mesh.s.edges) triple += e.wings.size() == 3;
  EXPECT_EQ(triple, static_cast<int>(mesh.p.edge_nodes[0][0].points.size()) - 1);
}

}  // namespace
}  // namespace toile
