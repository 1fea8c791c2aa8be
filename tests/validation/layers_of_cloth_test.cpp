// Layers of cloth lie on each other at their thickness, carry each other, and come apart when they start crossed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "runtime/body/primitives.hpp"
#include "runtime/contact/self_intersections.hpp"
#include "runtime/drape/drape.hpp"
#include "tests/support/incline.hpp"
#include "tests/support/sheet.hpp"

namespace toile {
namespace {

FabricSheet voile() {
  FabricSheet fabric;
  fabric.weight = 0.12;
  fabric.emt = WarpWeft{0.03, 0.08};
  fabric.b = WarpWeft{6e-6, 4e-6};
  fabric.t0 = 0.0006;
  return fabric;
}

/// Two sheets in one cloth: a large one, and a smaller one that starts over it.
struct TwoSheets {
  Cloth cloth;
  int lower = 0;  // vertices of the large one
  Placed start;
};

TwoSheets two_sheets(double lowest, double tilt) {
  const test::Sheet large = test::rectangle(0.2, 0.16, 10, 8), small = test::rectangle(0.1, 0.08, 5, 4);
  std::vector<Vec2> points = large.points;
  std::vector<std::array<int, 3>> triangles;
  for (const ClothTriangle& triangle : large.cloth.triangles) triangles.push_back(triangle.vertices);
  const int shift = static_cast<int>(points.size());
  for (const Vec2 p : small.points) points.push_back({p.x + 0.3, p.y});
  for (const ClothTriangle& triangle : small.cloth.triangles) {
    const auto& v = triangle.vertices;
    triangles.push_back({v[0] + shift, v[1] + shift, v[2] + shift});
  }
  TwoSheets two{test::cloth_of(points, triangles), shift, {}};
  for (const Vec2 p : large.points) two.start.positions.push_back({p.x, p.y, 0.001});
  for (const Vec2 p : small.points) {
    two.start.positions.push_back({p.x + 0.047, p.y + 0.038, lowest + (p.x + p.y) * std::tan(tilt)});
  }
  return two;
}

BodySpec table() {
  BodySpec spec;
  spec.name = "table";
  spec.shape = PlaneSpec{};
  return spec;
}

TEST(Layers, LieOnEachOtherAtTheirThickness) {
  const TwoSheets two = two_sheets(0.006, 0);
  std::string error;
  const auto body = make_primitive(table(), &error);
  ASSERT_NE(body, nullptr) << error;
  const Drape drape = toile::drape(two.cloth, voile(), body.get(), two.start, {.accuracy = 1e-4}, {});
  ASSERT_TRUE(drape.converged) << drape.trouble;
  EXPECT_EQ(drape.crossing_pairs, 0);
  // The table carries both, the one through the other.
  EXPECT_LT(drape.contact.weight_error, 1e-4);
  for (auto v = static_cast<std::size_t>(two.lower); v < drape.positions.size(); ++v) {
    EXPECT_GT(drape.positions[v].z, 0.0003 + 0.8 * 0.0006);
    EXPECT_LT(drape.positions[v].z, 0.0003 + 1.01 * 0.0006);
  }
  EXPECT_GT(drape.energy.self_contact, 0);
}

/// Turns them about y.
void lean(double tilt, std::vector<Vec3>& positions) {
  for (Vec3& p : positions) {
    p = {p.x * std::cos(tilt) + p.z * std::sin(tilt), p.y, p.z * std::cos(tilt) - p.x * std::sin(tilt)};
  }
}

/// A plate of cloth that is held and leans by `tilt`, and a strip upon it.
Drape strip_on_a_slope(double tilt, double friction, TwoSheets& two) {
  two = two_sheets(0.0019, 0);
  lean(tilt, two.start.positions);
  for (int v = 0; v < two.lower; ++v) two.start.held.push_back(v);
  FabricSheet fabric = voile();
  fabric.miu = friction;
  return toile::drape(two.cloth, fabric, nullptr, two.start, {.accuracy = 1e-4, .max_iterations = 150}, {});
}

TEST(Layers, StickOnASlopeOfClothBelowTheAngleOfFrictionAndSlideAbove) {
  for (const double friction : {0.2, 0.5}) {
    const double limit = std::atan(friction), margin = std::numbers::pi / 180;
    TwoSheets two;
    const Drape sticks = strip_on_a_slope(limit - margin, friction, two);
    const auto far = [&](const Drape& drape) { return distance(drape.positions.back(), two.start.positions.back()); };
    EXPECT_TRUE(sticks.converged) << friction << ": " << sticks.trouble;
    EXPECT_LT(far(sticks), 0.003) << friction;
    const Drape slides = strip_on_a_slope(limit + margin, friction, two);
    EXPECT_GT(far(slides), 0.008) << friction;
    EXPECT_FALSE(slides.converged);
  }
}

TEST(Layers, SlideOnALayerThatSticksToTheBody) {
  // A table that holds the lower sheet well; the cloths hold each other up to 16.7 degrees.
  const auto moved = [](double degrees) {
    const double tilt = degrees * std::numbers::pi / 180;
    const test::Incline slope(tilt, 0.8);
    TwoSheets two = two_sheets(0.0019, 0);
    lean(tilt, two.start.positions);
    FabricSheet fabric = voile();
    fabric.miu = 0.3;
    const Drape drape =
        toile::drape(two.cloth, fabric, &slope, two.start, {.accuracy = 1e-4, .max_iterations = 150}, {});
    EXPECT_LT(distance(drape.positions.front(), two.start.positions.front()), 0.002) << degrees;
    EXPECT_EQ(drape.crossing_pairs, 0);
    return distance(drape.positions.back(), two.start.positions.back());
  };
  EXPECT_LT(moved(15), 0.003);
  EXPECT_GT(moved(18.5), 0.008);
}

TEST(Layers, ComeApartWhenACornerStartsThroughTheOther) {
  const TwoSheets two = two_sheets(-0.002, 0.1);
  ASSERT_GT(intersecting_triangle_pairs(two.cloth, two.start.positions), 0);
  const Drape drape = toile::drape(two.cloth, voile(), nullptr, two.start, {.accuracy = 1e-3, .gravity = false}, {});
  EXPECT_EQ(drape.crossing_pairs, 0);
}

TEST(Layers, ComeApartWhenAStripHangsThroughTheOtherFromRimToRim) {
  TwoSheets two = two_sheets(0, 0);
  // It stands upright, three centimetres of it below the large sheet: the line in which they cross is as long as the
  // strip is wide, wherever the strip is drawn to.
  const test::Sheet small = test::rectangle(0.1, 0.08, 5, 4);
  for (std::size_t i = 0; i < small.points.size(); ++i) {
    two.start.positions[static_cast<std::size_t>(two.lower) + i] = {0.103, 0.037 + small.points[i].y,
                                                                    small.points[i].x - 0.03};
  }
  ASSERT_GT(intersecting_triangle_pairs(two.cloth, two.start.positions), 0);
  const Drape drape = toile::drape(two.cloth, voile(), nullptr, two.start, {.accuracy = 1e-3, .gravity = false}, {});
  EXPECT_EQ(drape.crossing_pairs, 0);
}

}  // namespace
}  // namespace toile
