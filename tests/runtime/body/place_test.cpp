// Initial positions: on the body's line, outside the body, little strained, no two the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/place/place.hpp"
#include "tests/compiler/mesh/garments.hpp"
#include "tests/runtime/body/sample_form.hpp"

namespace toile {
namespace {

struct Start {
  SewnMesh mesh;
  Cloth cloth;
  std::vector<Worn> worn;
  Placed placed;
};

Start start(const Garment& garment, const Body* body, double edge = 0.025) {
  PMeshOptions options;
  options.target_edge = edge;
  Start s{sew(garment, options), {}, {}, {}};
  s.cloth = make_cloth(s.mesh);
  for (const SMesh::WornLine& line : s.mesh.s.worn) {
    const Wear& wear = garment.wears[line.wear];
    s.worn.push_back({&line, wear.line, wear.held, wear.from});
  }
  s.placed = place(s.mesh, s.cloth, s.worn, {}, body);
  return s;
}

std::vector<double> strains(const Start& s) {
  std::vector<double> result;
  for (const ClothTriangle& t : s.cloth.triangles) {
    for (int c = 0; c < 3; ++c) {
      const double rest = distance(t.uv[c], t.uv[(c + 1) % 3]);
      const Vec3 a = s.placed.positions[t.vertices[c]], b = s.placed.positions[t.vertices[(c + 1) % 3]];
      result.push_back(distance(a, b) / rest - 1);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

double largest_strain(const Start& s) {
  const std::vector<double> all = strains(s);
  return std::max(-all.front(), all.back());
}

double middle_half_strain(const Start& s) {
  const std::vector<double> all = strains(s);
  return std::max(-all[all.size() / 4], all[3 * all.size() / 4]);
}

void expect_finite_and_apart(const Placed& placed) {
  std::vector<Vec3> sorted = placed.positions;
  std::sort(sorted.begin(), sorted.end(), [](Vec3 a, Vec3 b) { return a.x < b.x; });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    ASSERT_TRUE(std::isfinite(sorted[i].x + sorted[i].y + sorted[i].z));
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x - sorted[i].x < 1e-7; ++j) {
      ASSERT_GT(distance(sorted[i], sorted[j]), 1e-7);
    }
  }
}

void expect_outside(const Start& s, const Body& body) {
  std::vector<bool> is_held(s.placed.positions.size(), false);
  for (const int v : s.placed.held) is_held[v] = true;
  for (std::size_t v = 0; v < is_held.size(); ++v) {
    const auto found = body.nearest(s.placed.positions[v], 0);
    if (!found) continue;
    EXPECT_GT(found->distance, is_held[v] ? -1e-3 : -1e-9);
  }
  for (const ClothTriangle& t : s.cloth.triangles) {
    if (std::any_of(t.vertices.begin(), t.vertices.end(), [&](int v) { return is_held[v]; })) continue;
    const Vec3 middle =
        (s.placed.positions[t.vertices[0]] + s.placed.positions[t.vertices[1]] + s.placed.positions[t.vertices[2]]) / 3;
    EXPECT_FALSE(body.nearest(middle, 0));
  }
}

// The part of the cloth's area whose right side faces away from the upright line through (0, y).
double outward_part(const Start& s, double y) {
  double outward = 0, area = 0;
  for (const ClothTriangle& t : s.cloth.triangles) {
    const Vec3 a = s.placed.positions[t.vertices[0]], b = s.placed.positions[t.vertices[1]],
               c = s.placed.positions[t.vertices[2]];
    const Vec3 normal = cross(b - a, c - a);
    const Vec3 from_axis{a.x, a.y - y, 0};
    area += norm(normal);
    if (dot(normal, from_axis) > 0) outward += norm(normal);
  }
  return outward / area;
}

std::shared_ptr<const Body> sample_body() {
  return Body::make(body_of(sample_form()), nullptr);
}

// Two halves of a ring between two radii, `opening` [rad] each, seamed at the sides and worn at a line.
Garment ring_cape(double inner, double length, double opening, const std::string& line_name) {
  const auto half = [&](const char* name) {
    const double outer = inner + length, from = -test::pi / 2 - opening / 2;
    const Vec2 a = inner * direction(from), b = outer * direction(from);
    const Vec2 c = outer * direction(from + opening), d = inner * direction(from + opening);
    return test::piece(name, {test::edge("left", line(a, b)),
                              test::edge("hem", arc_through(b, outer * direction(from + opening / 2), c)),
                              test::edge("right", line(c, d)),
                              test::edge("neck", arc_through(d, inner * direction(from + opening / 2), a))});
  };
  Garment g = test::garment("cape", {half("front"), half("back")});
  test::sew_chains(g, {test::along(0, 2)}, {test::against(1, 0)});
  test::sew_chains(g, {test::along(1, 2)}, {test::against(0, 0)});
  g.wears.push_back({{test::along(0, 3), test::along(1, 3)}, line_name, true, 0, {}});
  return g;
}

TEST(Placing, ASkirtHangsAsAConeFromTheWaist) {
  const auto body = sample_body();
  const Start s = start(test::flared_skirt(), body.get());
  ASSERT_EQ(s.placed.error, "");
  expect_finite_and_apart(s.placed);
  expect_outside(s, *body);
  EXPECT_LT(middle_half_strain(s), 0.02);
  EXPECT_LT(largest_strain(s), 0.15);
  EXPECT_GT(outward_part(s, 0), 0.99);
  EXPECT_EQ(s.placed.held.size(), s.mesh.s.worn[0].vertices.size());
  for (const Vec3& p : s.placed.positions) EXPECT_LT(p.z, 1.02);
}

TEST(Placing, TheFirstEdgesMiddleIsAtTheFront) {
  const auto body = sample_body();
  Garment garment = test::flared_skirt();
  const auto front_of = [&](const Start& s) {
    Vec3 sum;
    int count = 0;
    for (std::size_t v = 0; v < s.placed.positions.size(); ++v) {
      const auto& corners = s.mesh.s.p_of_s[v];
      if (corners.size() != 1 || s.mesh.p.piece_of_point[corners.front()] != 0) continue;
      sum += s.placed.positions[v];
      ++count;
    }
    return sum / count;
  };
  const Vec3 front = front_of(start(garment, body.get()));
  EXPECT_LT(front.y, -0.05);
  EXPECT_NEAR(front.x, 0, 0.01);
  garment.wears[0].from = 0.25;  // a quarter counter-clockwise: to the wearer's left
  const Vec3 left = front_of(start(garment, body.get()));
  EXPECT_GT(left.x, 0.05);
}

TEST(Placing, ALongerChainKeepsItsLengthAndAShorterOneLiesOnTheLine) {
  const auto body = sample_body();
  const double girth = body->line("waist")->girth;
  for (const double length : {girth + 0.06, girth - 0.02}) {
    const double inner = length / 2 / 2.0;  // radius of two half rings that open by 2 rad
    const Start s = start(ring_cape(inner, 0.3, 2.0, "waist"), body.get());
    ASSERT_EQ(s.placed.error, "");
    double total = 0;
    const auto& chain = s.mesh.s.worn[0].vertices;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      total += distance(s.placed.positions[chain[i]], s.placed.positions[chain[(i + 1) % chain.size()]]);
    }
    EXPECT_NEAR(total, std::max(length, girth), 0.004);
    if (length > girth) continue;
    for (const int v : chain) EXPECT_NEAR(body->nearest(s.placed.positions[v], 1)->distance, 0, 1e-9);
  }
}

TEST(Placing, ACapeCoversTheShoulders) {
  const auto body = sample_body();
  for (const double opening : {2.6, 3.1}) {
    const Start s = start(ring_cape(0.40 / 2 / opening, 0.5, opening, "neck"), body.get());
    ASSERT_EQ(s.placed.error, "");
    expect_finite_and_apart(s.placed);
    expect_outside(s, *body);
    EXPECT_LT(middle_half_strain(s), 0.03);
    EXPECT_GT(outward_part(s, 0), 0.95);
  }
}

TEST(Placing, ATubeGoesAlongTheArm) {
  const auto body = sample_body();
  Garment sleeve = test::tube(0.42, 0.3);
  sleeve.wears.push_back({{test::along(0, 2)}, "left_armhole", true, 0, {}});
  const Start s = start(sleeve, body.get());
  ASSERT_EQ(s.placed.error, "");
  expect_finite_and_apart(s.placed);
  const BodyLine& line = *body->line("left_armhole");
  double farthest = 0;
  for (const Vec3& p : s.placed.positions) farthest = std::max(farthest, dot(p - line.points[0], line.axis));
  EXPECT_GT(farthest, 0.2);
  for (const Vec3& p : s.placed.positions) EXPECT_GT(p.x, 0.1);
}

TEST(Placing, TheSameInputGivesTheSameBits) {
  const auto body = sample_body();
  const Start first = start(test::flared_skirt(), body.get()), second = start(test::flared_skirt(), body.get());
  EXPECT_EQ(first.placed.positions, second.placed.positions);
  EXPECT_EQ(start(test::torus(), nullptr).placed.positions, start(test::torus(), nullptr).placed.positions);
}

TEST(Placing, AClothThatIsNotWornLiesFlatAboveTheBody) {
  const auto ball = Body::make(body_of(SphereSpec{0.15, 0.15}), nullptr);
  const Start s = start(test::garment("cloth", {test::rectangle("square", 0.6, 0.6)}), ball.get());
  ASSERT_EQ(s.placed.error, "");
  EXPECT_TRUE(s.placed.held.empty());
  Vec3 sum;
  for (std::size_t v = 0; v < s.placed.positions.size(); ++v) {
    const Vec3 p = s.placed.positions[v];
    EXPECT_NEAR(p.z, 0.302, 1e-9);
    sum += s.cloth.area_of_vertex[v] * p;
  }
  EXPECT_NEAR(sum.x / s.cloth.area, 0, 1e-9);
  EXPECT_NEAR(sum.y / s.cloth.area, 0, 1e-9);
  EXPECT_LT(largest_strain(s), 1e-9);
}

TEST(Placing, SewnSurfacesWithoutABodyTakeTheirOwnShape) {
  const Start tube = start(test::tube(), nullptr);
  EXPECT_LT(largest_strain(tube), 0.12);
  const Start torus = start(test::closed_square(false, false, 0.8, 0.24), nullptr);
  EXPECT_LT(middle_half_strain(torus), 0.2);
  double low = 1e9, high = -1e9, nearest_axis = 1e9;
  for (const Vec3& p : torus.placed.positions) {
    low = std::min(low, p.z), high = std::max(high, p.z);
    nearest_axis = std::min(nearest_axis, std::hypot(p.x, p.y));
  }
  EXPECT_NEAR(high - low, 0.24 / test::pi, 0.02);  // the tube's diameter
  EXPECT_GT(nearest_axis, 0.05);                   // and the ring's hole
  for (const Garment& g : {test::tube(), test::torus(), test::klein_bottle(), test::projective_plane(),
                           test::moebius_strip(), test::sphere_of_two_discs(), test::cap(6), test::cone(2.0)}) {
    const Start s = start(g, nullptr, 0.03);
    ASSERT_EQ(s.placed.error, "") << g.name;
    expect_finite_and_apart(s.placed);
  }
}

TEST(Placing, SeparatePiecesDoNotLieOnEachOther) {
  const Garment g = test::garment("two", {test::rectangle("a", 0.3, 0.2), test::rectangle("b", 0.3, 0.2)});
  expect_finite_and_apart(start(g, nullptr).placed);
  const auto plate = Body::make(body_of(DiscSpec{0.09, 0.01, 1.0}), nullptr);
  expect_finite_and_apart(start(g, plate.get()).placed);
}

TEST(Placing, SaysWhichLinesThereAre) {
  const auto body = sample_body();
  Garment garment = test::flared_skirt();
  garment.wears[0].line = "wais";
  EXPECT_EQ(start(garment, body.get()).placed.error,
            "the body body has no line `wais` (did you mean `waist`?); its lines are hip, waist, bust, neck, "
            "left_armhole, right_armhole, left_leg, right_leg, left_crotch, right_crotch");
  EXPECT_EQ(start(test::flared_skirt(), nullptr).placed.error,
            "without a body there is no line `waist` to wear a garment at");
  const auto box = Body::make(body_of(BoxSpec{1, 1, 1, 1}), nullptr);
  EXPECT_EQ(start(test::flared_skirt(), box.get()).placed.error, "the body body has no lines, and so no `waist`");
}

}  // namespace
}  // namespace toile
