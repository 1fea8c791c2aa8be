// Trousers: each leg's cloth around its own leg, both on their sides of the plane between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/place/leg_rings.hpp"
#include "runtime/place/place.hpp"
#include "runtime/place/worn_legs.hpp"
#include "tests/compiler/mesh/garments.hpp"
#include "tests/runtime/body/sample_form.hpp"

namespace toile {
namespace {

// Edges 0 crotch, 1 inseam, 2 hem, 3 side, 4 hip, 5 waist; the wearer's left of the front, the right of the back.
Piece trouser_piece(const char* name, double fork, double length) {
  const double waist = 0.18, quarter = 0.25, hem = 0.22;
  const Vec2 outer{quarter - fork / 2 - 0.01, -length}, inner = outer - Vec2{hem, 0};
  return test::piece(name,
                     {test::edge("crotch", tangent_curve({0, 0}, -test::pi / 2, {-fork, -0.29}, -test::pi + 0.1)),
                      test::edge("inseam", line({-fork, -0.29}, inner)), test::edge("hem", line(inner, outer)),
                      test::edge("side", line(outer, {quarter, -0.19})),
                      test::edge("hip", tangent_curve({quarter, -0.19}, test::pi / 2, {waist, 0.01}, test::pi - 1.2)),
                      test::edge("waist", line({waist, 0.01}, {0, 0}))});
}

// The same edges the other way round: 5 crotch, …, 0 waist.
Piece mirrored(const Piece& drawn) {
  Piece copy = drawn;
  copy.side = Side::Mirrored;
  std::reverse(copy.edges.begin(), copy.edges.end());
  for (PieceEdge& edge : copy.edges) edge.curve = edge.curve.reversed().mirrored({0, 0}, {0, 1});
  return copy;
}

Garment trousers(double length) {
  using test::against, test::along;
  const Piece front = trouser_piece("front", 0.05, length), back = trouser_piece("back", 0.09, length);
  Garment g = test::garment("trousers", {front, mirrored(front), back, mirrored(back)});
  for (const int edge : {1, 3, 4}) {
    test::sew_chains(g, {along(0, edge)}, {against(3, 5 - edge)});
    test::sew_chains(g, {along(1, 5 - edge)}, {against(2, edge)});
  }
  test::sew_chains(g, {along(0, 0)}, {against(1, 5)});
  test::sew_chains(g, {along(2, 0)}, {against(3, 5)});
  g.wears = {{{along(0, 5), along(1, 0), along(2, 5), along(3, 0)}, "waist", true, 0, {}},
             {{along(0, 0), along(3, 5)}, "left_crotch", false, 0, {}},
             {{along(2, 0), along(1, 5)}, "right_crotch", false, 0, {}}};
  return g;
}

struct PlacedTrousers {
  std::shared_ptr<const Body> body = Body::make(body_of(sample_form()), nullptr);
  SewnMesh mesh;
  Cloth cloth;
  Placed placed;

  explicit PlacedTrousers(double length = 0.98) {
    const Garment garment = trousers(length);
    PMeshOptions options;
    options.target_edge = 0.025;
    mesh = sew(garment, options);
    cloth = make_cloth(mesh);
    std::vector<Worn> worn;
    for (const SMesh::WornLine& line : mesh.s.worn) {
      worn.push_back({&line, garment.wears[line.wear].line, garment.wears[line.wear].held, 0});
    }
    placed = place(mesh, cloth, worn, {}, body.get());
  }
};

TEST(Legs, CrotchLinesRunAlongTheirAxis) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  for (const BodyLine& line : body->lines()) {
    EXPECT_EQ(runs_along_axis(line), line.name.ends_with("crotch")) << line.name;
  }
}

TEST(Legs, RingsFollowTheLeg) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  const BodyLine& crotch = *body->line("left_crotch");
  const BodyLine& root = *body->line("left_leg");
  const LegFrame frame(crotch.axis);
  Vec3 start;
  for (const Vec3& p : crotch.points) start += p / static_cast<double>(crotch.points.size());
  const double level = frame.level(root.points[0]);
  const LegRings rings(*body, frame, {{{0, 0, 0}, {-1, 0, 0}}}, start, frame.level({0, 0, 1.0}), level + 0.5, 0.002);
  EXPECT_NEAR(rings.girth(level), root.girth + 2 * test::pi * 0.002, 0.03);
  for (int k = 0; k < 16; ++k) {
    const double fraction = k / 16.0;
    for (const double below : {0.05, 0.2, 0.45}) {
      const Vec3 p = rings.at(level + below, fraction, 0);
      EXPECT_NEAR(body->nearest(p, 0.1)->distance, 0.002, 0.002);
      EXPECT_NEAR(std::remainder(rings.fraction_of(p) - fraction, 1.0), 0, 0.02);
      EXPECT_GT(p.x, 0);
    }
  }
  EXPECT_GT(rings.at(level, 0.25, 0).x, rings.at(level, 0.75, 0).x);  // a quarter is to the wearer's left
}

TEST(Legs, EachHasItsClothAroundIt) {
  const PlacedTrousers t;
  ASSERT_EQ(t.placed.error, "");
  // Below the fork every ring of cloth goes once round its leg: directions seen from the leg's middle are all met.
  for (const char* name : {"left_leg", "right_leg"}) {
    const BodyLine& root = *t.body->line(name);
    Vec3 middle;
    for (const Vec3& p : root.points) middle += p / static_cast<double>(root.points.size());
    for (const double below : {0.1, 0.3, 0.5}) {
      const Vec3 centre = middle + below * root.axis;
      std::vector<bool> met(8, false);
      for (const Vec3& p : t.placed.positions) {
        if (std::abs(p.z - centre.z) > 0.02 || p.x * centre.x < 0) continue;
        const double turn = std::atan2(p.y - centre.y, p.x - centre.x) / (2 * test::pi) + 0.5;
        met[std::min(7, static_cast<int>(8 * turn))] = true;
        EXPECT_LT(std::hypot(p.x - centre.x, p.y - centre.y), 0.16);
      }
      EXPECT_EQ(std::count(met.begin(), met.end(), true), 8) << name << " " << below;
    }
  }
}

TEST(Legs, KeepToTheirSides) {
  const PlacedTrousers t;
  for (std::size_t v = 0; v < t.placed.positions.size(); ++v) {
    for (const int p : t.mesh.s.p_of_s[v]) {
      // Front and back of one leg are the drawn copy of the one and the mirrored copy of the other.
      const PieceId piece = t.mesh.p.piece_of_point[p];
      const double side = piece == 0 || piece == 3 ? 1 : -1;
      EXPECT_GT(side * t.placed.positions[v].x, -0.004);
    }
  }
}

TEST(Legs, StartOutsideTheBodyAndLittleStrained) {
  const PlacedTrousers t;
  std::vector<bool> worn(t.placed.positions.size(), false);
  for (const SMesh::WornLine& line : t.mesh.s.worn) {
    for (const int v : line.vertices) worn[v] = true;
  }
  for (std::size_t v = 0; v < worn.size(); ++v) {
    const auto found = t.body->nearest(t.placed.positions[v], 0);
    if (!found) continue;
    EXPECT_GT(found->distance, worn[v] ? -2e-3 : -1e-9);
  }
  std::vector<double> strains;
  for (const ClothTriangle& triangle : t.cloth.triangles) {
    for (int c = 0; c < 3; ++c) {
      const double rest = distance(triangle.uv[c], triangle.uv[(c + 1) % 3]);
      strains.push_back(
          distance(t.placed.positions[triangle.vertices[c]], t.placed.positions[triangle.vertices[(c + 1) % 3]]) /
              rest -
          1);
    }
  }
  std::sort(strains.begin(), strains.end());
  EXPECT_GT(strains[strains.size() / 10], -0.1);
  EXPECT_LT(strains[strains.size() * 9 / 10], 0.1);
  EXPECT_LT(strains.back(), 0.8);
}

TEST(Legs, HangFromTheWaistLevel) {
  const PlacedTrousers t;
  double low = 1e9, high = -1e9;
  for (const Vec3& p : t.placed.positions) {
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  EXPECT_NEAR(high, 1.015, 0.01);
  EXPECT_NEAR(low, 1.015 - 0.98, 0.05);
}

TEST(Legs, LongerThanTheBodysGoOnBelowThem) {
  const PlacedTrousers t(1.1);
  ASSERT_EQ(t.placed.error, "");
  for (const Vec3& p : t.placed.positions) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
}

}  // namespace
}  // namespace toile
