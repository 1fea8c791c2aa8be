// Lines inside a piece: edges of the mesh lie on them, and what is sewn there shares their nodes.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compiler/mesh/checks.hpp"

namespace toile {
namespace {

using namespace test;  // NOLINT

const std::vector<Vec2> kPocket{{0.15, 0.25}, {0.15, 0.12}, {0.22, 0.08}, {0.3, 0.12}, {0.3, 0.25}};

/// A sheet with the line of a pocket, its edges 4 to 7, and the pocket itself, open above at its edge 4.
Garment pocket() {
  Piece sheet = rectangle("sheet", 0.5, 0.4);
  std::vector<PieceEdge>& place = sheet.lines.emplace_back();
  for (std::size_t i = 0; i < 4; ++i)
    place.push_back(edge("place." + std::to_string(i), line(kPocket[i], kPocket[i + 1])));
  Garment g = garment("apron", {sheet, polygon("pocket", kPocket)});
  sew_chains(g, {along(1, 0), along(1, 1), along(1, 2), along(1, 3)},
             {along(0, 4), along(0, 5), along(0, 6), along(0, 7)});
  return g;
}

/// Two lines from the upper edge down, which are sewn to each other.
Garment tuck() {
  Piece sheet = rectangle("sheet", 0.5, 0.4);
  sheet.lines = {{edge("first.a", line({0.2, 0.35}, {0.2, 0.1}))}, {edge("second.a", line({0.24, 0.35}, {0.24, 0.1}))}};
  Garment g = garment("tucked", {sheet});
  sew_chains(g, {along(0, 4)}, {along(0, 5)});
  return g;
}

int edges_with(const SMesh& s, std::size_t wings) {
  return static_cast<int>(
      std::count_if(s.edges.begin(), s.edges.end(), [&](const SMesh::Edge& e) { return e.wings.size() == wings; }));
}

PieceId piece_of(const SewnMesh& mesh, const SMesh::Wing& wing) {
  return mesh.p.piece_of_triangle[static_cast<std::size_t>(wing.triangle)];
}

TEST(Lines, CarryAPocketOfWhichTheSheetBelowBendsAsOneCloth) {
  const Garment g = pocket();
  for (const double edge : {0.04, 0.015, 0.006}) {
    const SewnMesh mesh = sew(g, {.target_edge = edge});
    expect_cells_agree(g, mesh);
    expect_sound(mesh.p, g);
    expect_equal_fractions(mesh.p, g);
    expect_strict(mesh);
    expect_consistent(mesh);
    EXPECT_NEAR(area(mesh.p), 0.5 * 0.4 + area(make_pmesh(garment("alone", {g.pieces[1]}), {})), 1e-9);
    // The pocket hangs on the sheet by an arc: together they are as one disc, with the mouth as a second boundary.
    EXPECT_EQ(mesh.s.topology.components, 1);
    EXPECT_EQ(mesh.s.topology.euler, 1);
    EXPECT_EQ(mesh.s.topology.boundary_loops, 2);
    EXPECT_FALSE(mesh.s.topology.manifold);
    std::size_t sides = 0;
    for (const auto& run : mesh.p.sewn[0]) sides += run.first.size() - 1;
    EXPECT_EQ(edges_with(mesh.s, 3), static_cast<int>(sides));
    for (const SMesh::Edge& e : mesh.s.edges) {
      if (e.wings.size() != 3) continue;
      EXPECT_EQ(piece_of(mesh, e.wings[0]), 0);
      EXPECT_EQ(piece_of(mesh, e.wings[1]), 0);
      EXPECT_EQ(piece_of(mesh, e.wings[2]), 1);
    }
  }
}

TEST(Lines, HaveTrianglesAsGoodAsElsewhere) {
  const Garment g = pocket();
  const AngleFigures figures = angles(make_pmesh(g, {}));
  EXPECT_GT(figures.least, 20);
}

TEST(Lines, SewnToEachOtherRunOnOverATuck) {
  const Garment g = tuck();
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  expect_strict(mesh);
  EXPECT_EQ(mesh.s.topology.components, 1);
  EXPECT_GT(edges_with(mesh.s, 4), 10);
  for (const SMesh::Edge& e : mesh.s.edges) {
    if (e.wings.size() != 4) continue;
    EXPECT_EQ(e.pairs, 2);
    // Of the first two neither lies in the strip between the lines.
    for (std::size_t w = 0; w < 4; ++w) {
      Vec2 middle;
      for (const int p : mesh.p.triangles[static_cast<std::size_t>(e.wings[w].triangle)]) {
        middle = middle + mesh.p.points[static_cast<std::size_t>(p)] / 3;
      }
      EXPECT_EQ(middle.x > 0.2 && middle.x<0.24, w> 1);
    }
  }
}

TEST(Lines, OfTwoPiecesQuiltThem) {
  Garment g = garment("quilt", {});
  for (const char* name : {"upper", "lower"}) {
    Piece sheet = rectangle(name, 0.5, 0.4);
    sheet.lines = {{edge("quilting.a", line({0.1, 0.2}, {0.4, 0.25}))}};
    g.pieces.push_back(sheet);
  }
  sew_chains(g, {along(0, 4)}, {along(1, 4)});
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  expect_strict(mesh);
  for (const SMesh::Edge& e : mesh.s.edges) {
    if (e.wings.size() != 4) continue;
    EXPECT_EQ(piece_of(mesh, e.wings[0]), piece_of(mesh, e.wings[1]));
    EXPECT_EQ(piece_of(mesh, e.wings[2]), piece_of(mesh, e.wings[3]));
  }
}

TEST(Lines, ShareTheirEndsWithTheOutlineAndWithEachOther) {
  Piece sheet = polygon("sheet", {{0, 0}, {0.5, 0}, {0.5, 0.4}, {0.25, 0.4}, {0, 0.4}});
  sheet.lines = {{edge("a.x", line({0.25, 0.4}, {0.25, 0.2}))}, {edge("b.x", line({0.25, 0.2}, {0.1, 0.1}))}};
  const Garment g = garment("parted", {sheet});
  const PMesh mesh = make_pmesh(g, {});
  expect_sound(mesh, g);
  const auto& nodes = mesh.edge_nodes[0];
  EXPECT_EQ(nodes[5].points.front(), nodes[2].points.back());
  EXPECT_EQ(nodes[5].points.back(), nodes[6].points.front());
}

}  // namespace
}  // namespace toile
