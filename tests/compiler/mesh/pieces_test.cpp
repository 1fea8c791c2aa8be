// The mesh of single pieces: angles, sizes, curves followed, whatever the shape.
#include <gtest/gtest.h>

#include "tests/compiler/mesh/checks.hpp"

namespace toile {
namespace {

using namespace test;  // NOLINT

PMesh mesh_of(const Piece& piece, double edge = 0.015) {
  const Garment g = garment("one", {piece});
  PMeshOptions options;
  options.target_edge = edge;
  PMesh mesh = make_pmesh(g, options);
  expect_sound(mesh, g);
  return mesh;
}

double mean_edge(const PMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) sum += distance(mesh.points[t[c]], mesh.points[t[(c + 1) % 3]]);
  }
  return sum / (3 * static_cast<double>(mesh.triangles.size()));
}

TEST(Pieces, HaveGoodAnglesAndTheTargetEdge) {
  for (const Piece& piece : {rectangle("square", 0.6, 0.6), disc("disc", 0.3), skirt_panel("skirt", 0.4, 0.6, 0.14),
                             sector("quarter", 0.7, pi / 2), gore("gore", 0.2, 0.4)}) {
    for (const double target : {0.03, 0.015, 0.008}) {
      SCOPED_TRACE(testing::Message() << piece.name << " at " << target);
      const PMesh mesh = mesh_of(piece, target);
      const AngleFigures figures = angles(mesh);
      EXPECT_GE(figures.least, 25);
      EXPECT_NEAR(mean_edge(mesh) / target, 1, 0.2);
      double longest = 0;
      for (const auto& t : mesh.triangles) {
        for (int c = 0; c < 3; ++c)
          longest = std::max(longest, distance(mesh.points[t[c]], mesh.points[t[(c + 1) % 3]]));
      }
      EXPECT_LT(longest, 1.8 * target);
    }
  }
}

TEST(Pieces, KeepTheirAreaWithinTheChordError) {
  for (const double chord_error : {1e-3, 2e-4, 1e-5}) {
    const double radius = 0.2;
    const Garment g = garment("disc", {disc("disc", radius)});
    PMeshOptions options;
    options.target_edge = 0.05;
    options.chord_error = chord_error;
    const PMesh mesh = make_pmesh(g, options);
    const double missing = pi * radius * radius - area(mesh);
    EXPECT_GT(missing, 0);
    EXPECT_LT(missing, 2 * pi * radius * chord_error);
  }
}

TEST(Pieces, FollowTheirCurvesWithinTheChordError) {
  Piece wavy = piece("wavy", {edge("wave", bezier({0, 0}, {0.3, -0.4}, {0.0, 0.4}, {0.3, 0})),
                              edge("fillet", arc_of_radius({0.3, 0}, {0.305, 0.005}, 0.005)),
                              edge("back", join({line({0.305, 0.005}, {0.3, 0.3}), line({0.3, 0.3}, {0, 0.3})})),
                              edge("down", line({0, 0.3}, {0, 0}))});
  const Garment g = garment("wavy", {wavy});
  const PMeshOptions options;
  const PMesh mesh = make_pmesh(g, options);
  expect_sound(mesh, g);
  for (std::size_t e = 0; e < wavy.edges.size(); ++e) {
    const auto& nodes = mesh.edge_nodes[0][e];
    for (std::size_t i = 0; i + 1 < nodes.arc.size(); ++i) {
      const Vec2 a = mesh.points[nodes.points[i]], b = mesh.points[nodes.points[i + 1]];
      for (int k = 1; k < 40; ++k) {
        const Vec2 p = wavy.edges[e].curve.at(nodes.arc[i] + (nodes.arc[i + 1] - nodes.arc[i]) * k / 40);
        EXPECT_LT(std::abs(cross(b - a, p - a)) / distance(a, b), 1.05 * options.chord_error);
      }
    }
  }
  // The kink between the two lines of one edge is a node.
  const auto& back = mesh.edge_nodes[0][2];
  EXPECT_TRUE(std::any_of(back.points.begin(), back.points.end(), [&](int p) {
    return distance(mesh.points[p], {0.3, 0.3}) < 1e-12;
  }));
}

TEST(Pieces, WhoseChordsWouldCrossAreDividedMoreFinely) {
  // Two arcs 0.1 mm apart, far less than the chords stray: a bias strip.
  const double r = 0.1, gap = 1e-4;
  const Garment g = garment(
      "strip",
      {piece("strip", {edge("outer", arc_through({r, 0}, {0, r}, {-r, 0})), edge("end", line({-r, 0}, {gap - r, 0})),
                       edge("inner", arc_through({gap - r, 0}, {0, r - gap}, {r - gap, 0})),
                       edge("start", line({r - gap, 0}, {r, 0}))})});
  PMeshOptions options;
  options.chord_error = 1e-3;
  const PMesh mesh = make_pmesh(g, options);
  expect_sound(mesh, g);
  EXPECT_NEAR(area(mesh), pi * (r * r - (r - gap) * (r - gap)) / 2, 5e-6);
}

TEST(Pieces, LeaveHolesOpen) {
  Piece holed = rectangle("holed", 0.3, 0.3);
  holed.holes.push_back({edge("neck", circle({0.15, 0.15}, {0.2, 0.15}, false))});
  holed.holes.push_back(
      {edge("slot", line({0.02, 0.02}, {0.02, 0.025})), edge("slot", line({0.02, 0.025}, {0.28, 0.025})),
       edge("slot", line({0.28, 0.025}, {0.28, 0.02})), edge("slot", line({0.28, 0.02}, {0.02, 0.02}))});
  const Garment g = garment("holed", {holed});
  const SewnMesh mesh = sew(g, {});
  expect_cells_agree(g, mesh);
  expect_sound(mesh.p, g);
  EXPECT_NEAR(area(mesh.p), 0.09 - pi * 0.0025 - 0.26 * 0.005, 2 * pi * 0.05 * 0.0002);
  EXPECT_EQ(mesh.s.topology.boundary_loops, 3);
  EXPECT_EQ(mesh.s.topology.euler, -1);
  EXPECT_GE(angles(mesh.p).least, 20);
}

struct Nasty {
  Piece piece;
  std::vector<Vec2> sharp;
  double clearance;
  std::size_t most_triangles;
};

TEST(Pieces, OfNastyShapesAreMeshedAllTheSame) {
  const double a3 = 3 * pi / 180;
  const std::vector<Nasty> shapes{
      {rectangle("strip", 0.8, 0.005), {}, 0, 500},
      {rectangle("thread", 1.0, 0.0005), {}, 0, 8000},
      {polygon("needle", {{0, 0}, {0.3, 0}, 0.3 * direction(a3)}), {{0, 0}}, 0.07, 400},
      {polygon("sliver", {{0, 0}, {0.3, -0.004}, {0.6, 0}, {0.3, 0.004}}), {{0, 0}, {0.6, 0}}, 0.12, 1500},
      {polygon("short edges", {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0.001, 0.3}, {0, 0.299}}), {}, 0, 1500},
      {polygon("thin dart", {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0.1502, 0.3}, {0.15, 0.2}, {0.1498, 0.3}, {0, 0.3}}),
       {},
       0,
       1500},
      {polygon("comb", {{0, 0},
                        {0.2, 0},
                        {0.2, 0.2},
                        {0.195, 0.002},
                        {0.19, 0.2},
                        {0.15, 0.2},
                        {0.15, 0.01},
                        {0.1, 0.01},
                        {0.1, 0.2},
                        {0, 0.2}}),
       {{0.2, 0.2}, {0.19, 0.2}, {0.195, 0.002}},
       0.13,
       3000},
      {polygon("step", {{0, 0}, {0.3, 0}, {0.3, 0.2}, {0.2, 0.2}, {0.2, 0.1998}, {0.1, 0.1998}, {0.1, 0.2}, {0, 0.2}}),
       {},
       0,
       1500},
  };
  for (const Nasty& shape : shapes) {
    SCOPED_TRACE(shape.piece.name);
    const PMesh mesh = mesh_of(shape.piece);
    const AngleFigures figures = angles(mesh, shape.sharp, shape.clearance);
    EXPECT_GE(figures.least, 20);
    EXPECT_LE(figures.below_25, 0.01);
    EXPECT_LT(mesh.triangles.size(), shape.most_triangles);
    double exact = 0;
    for (const auto& e : shape.piece.edges) exact += cross(e.curve.start(), e.curve.end()) / 2;
    EXPECT_NEAR(area(mesh), exact, 1e-12);
  }
}

TEST(Pieces, OfTwoMetresAndMoreStayWithinBounds) {
  EXPECT_NEAR(static_cast<double>(mesh_of(rectangle("sheet", 2, 2), 0.02).triangles.size()), 24150, 1500);
}

}  // namespace
}  // namespace toile
