// Pleats are put on folded.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "compiler/pattern/draft.hpp"
#include "runtime/place/place.hpp"
#include "tests/runtime/body/sample_form.hpp"

namespace toile {
namespace {

/// A skirt of one piece, closed behind, with knife pleats all round.
DraftGarment pleated_skirt(double girth, int pleats, double depth) {
  const double width = girth + 2 * depth * pleats, length = 0.4;
  const std::vector<Vec2> corners{{0, 0}, {width, 0}, {width, -length}, {0, -length}};
  const std::vector<std::string> names{"waist", "right", "hem", "left"};
  DraftGarment draft;
  DraftPiece& piece = draft.pieces.emplace_back();
  piece.name = "skirt";
  for (std::size_t i = 0; i < 4; ++i) piece.outline.push_back({names[i], line(corners[i], corners[(i + 1) % 4]), {}});
  for (int i = 0; i < pleats; ++i) {
    DraftPleat pleat;
    pleat.name = "pleat" + std::to_string(i + 1);
    pleat.place = {"waist", (i + 0.5) * width / pleats};
    pleat.depth = depth;
    pleat.pressed = Press::Left;
    piece.pleats.push_back(pleat);
  }
  DraftSeam back;
  back.first = {{"skirt", "left", {}, {}}};
  back.second = {{"skirt", "right", {}, {}}};
  draft.seams = {back};
  draft.wears = {{{{"skirt", "waist", {}, {}}}, "waist", true, 0, {}}};
  return draft;
}

TEST(PlacedPleats, LieInThreeLayersOfWhichTheMiddleOneIsTurnedOver) {
  const int pleats = 6;
  const double depth = 0.03;
  std::vector<Diagnostic> diagnostics;
  const Garment garment = make_garment(pleated_skirt(0.7, pleats, depth), diagnostics);
  ASSERT_TRUE(diagnostics.empty()) << diagnostics.front().message;
  const SewnMesh mesh = sew(garment, {});
  const Cloth cloth = make_cloth(mesh);
  const std::shared_ptr<const Body> body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  const std::vector<Worn> worn{{&mesh.s.worn[0], "waist", true, 0}};
  const Placed placed = place(mesh, cloth, worn, {}, body.get());
  ASSERT_EQ(placed.error, "");

  int turned = 0, under = 0, outwards = 0, others = 0;
  const double width = 0.7 + 2 * depth * pleats, spacing = width / pleats;
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    Vec2 middle;
    for (const int p : mesh.p.triangles[t]) middle = middle + mesh.p.points[p] / 3;
    if (middle.y > -0.1 || middle.y < -0.3) continue;  // where seam and hem are far
    const auto& v = cloth.triangles[t].vertices;
    const Vec3 a = placed.positions[v[0]], b = placed.positions[v[1]], c = placed.positions[v[2]];
    const Vec3 normal = cross(b - a, c - a), out{a.x, a.y, 0};
    // The fold points to the left: the cloth turned back lies there, from the fold to a depth on.
    const double from_fold = std::fmod(middle.x, spacing) - spacing / 2;
    const bool is_under = from_fold < -0.15 * depth && from_fold > -0.85 * depth;
    const bool is_face = from_fold > 0.3 * depth || from_fold < -1.3 * depth;
    under += is_under;
    turned += is_under && dot(normal, out) < 0;
    others += is_face;
    outwards += is_face && dot(normal, out) > 0;
  }
  EXPECT_GT(under, 50);
  EXPECT_GT(turned, 0.9 * under);
  EXPECT_GT(outwards, 0.9 * others);
}

}  // namespace
}  // namespace toile
