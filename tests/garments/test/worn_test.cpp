// Garments as they are put on: over each other, the right way round, and off again where nothing holds them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <variant>

#include "runtime/driver/workroom.hpp"
#include "tests/garments/trial.hpp"

namespace toile::test {
namespace {

struct Quiet final : Listener {
  std::string said;
  void diagnosed(const Diagnostic& diagnostic, const Sources&) override { said += diagnostic.message + " "; }
  void printed(const std::string&) override {}
  void noted(const std::string&) override {}
  void wrote(const std::string&) override {}
  void failed(const std::string& message, const std::string&) override { said += message; }
};

const char* const two_tubes = R"(
import bodies
import fabrics
body post = cylinder(radius: 10cm, length: 80cm, height: 60cm, upright: true)
piece sheet(around, long) {
  outline from (0cm, 0cm) {
    head  = line to (around, 0cm)
    right = line to (around, -long)
    foot  = line to (0cm, -long)
    left  = line to start
  }
}
garment inner in fabrics.denim {
  piece tube = sheet(75cm, 40cm)
  sew tube.left to tube.right
  wear tube.head at post.top
}
garment outer in fabrics.silk {
  piece tube = sheet(72cm, 25cm)
  sew tube.left to tube.right
  wear tube.head at post.top
}
)";

std::optional<Draped> drape(const std::string& script, int triangles, Quiet& heard) {
  WorkroomOptions options;
  options.triangles = triangles;
  options.threads = 1;
  Workroom workroom(options, heard, {});
  if (!workroom.load("worn.toile", script)) return std::nullopt;
  while (const std::optional<Command> command = workroom.next()) {
    if (const auto* drape = std::get_if<DrapeCommand>(&*command)) return workroom.drape(*drape);
  }
  return std::nullopt;
}

/// The mean distance from the axis of the cloth of one garment between two heights.
double mean_radius(const Draped& draped, int layer, double low, double high) {
  double sum = 0;
  int count = 0;
  for (const ClothTriangle& triangle : draped.made->cloth.triangles) {
    for (const int v : triangle.vertices) {
      const Vec3 p = draped.drape.positions[static_cast<std::size_t>(v)];
      if (triangle.fabric != layer || p.z < low || p.z > high) continue;
      sum += std::hypot(p.x, p.y);
      ++count;
    }
  }
  return sum / count;
}

TEST(WornOverEachOther, KeepTheOrderThatIsSaidAndEachItsCloth) {
  for (const bool swapped : {false, true}) {
    Quiet heard;
    const std::string command =
        swapped ? "drape inner over outer on post as worn\n" : "drape outer over inner on post as worn\n";
    const std::optional<Draped> draped = drape(two_tubes + command, 500, heard);
    ASSERT_TRUE(draped) << heard.said;
    EXPECT_TRUE(draped->drape.converged) << heard.said;
    EXPECT_EQ(draped->drape.crossing_pairs, 0);
    EXPECT_GT(mean_radius(*draped, 1, 0.8, 0.95), mean_radius(*draped, 0, 0.8, 0.95));
    // 390 g/m2 of denim over 75 cm x 40 cm and silk over 72 cm x 25 cm, in either order.
    const std::vector<FabricSheet> fabrics = draped->made->garment.fabrics();
    ASSERT_EQ(fabrics.size(), 2U);
    const double denim = 0.75 * 0.4 * *fabrics[swapped ? 1 : 0].weight,
                 silk = 0.72 * 0.25 * *fabrics[swapped ? 0 : 1].weight;
    EXPECT_NEAR(draped->drape.contact.weight_N, 9.80665 * (denim + silk), 1e-6);
  }
}

TEST(Worn, WhatNothingHoldsIsSaidToFall) {
  Quiet heard;
  const std::string loose = std::string(two_tubes) + R"(
garment ring in fabrics.denim {
  piece tube = sheet(110cm, 10cm)
  sew tube.left to tube.right
  wear tube.head at post.top placed
}
drape ring on post as worn
)";
  const std::optional<Draped> draped = drape(loose, 120, heard);
  ASSERT_TRUE(draped) << heard.said;
  EXPECT_FALSE(draped->drape.converged);
  EXPECT_THAT(heard.said, testing::HasSubstr("slides off the body"));
  EXPECT_LT(draped->drape.iterations, 600);
}

TEST(Worn, ATShirtIsNotTwistedByItsNeckband) {
  const std::string script = R"(
import "examples/t_shirt/t_shirt.toile" as base
drape base.t_shirt on base.form as worn
)";
  WorkroomOptions options;
  options.triangles = 500;
  options.threads = 1;
  Quiet heard;
  Workroom workroom(options, heard, {});
  ASSERT_TRUE(workroom.load("worn.toile", script, TOILE_SOURCE_DIR)) << heard.said;
  const std::optional<Command> command = workroom.next();
  ASSERT_TRUE(command);
  const std::optional<Draped> draped = workroom.drape(std::get<DrapeCommand>(*command));
  ASSERT_TRUE(draped) << heard.said;
  EXPECT_EQ(draped->drape.crossing_pairs, 0);
  double front = 0, back = 0;
  int fronts = 0, backs = 0;
  const SewnMesh& mesh = draped->made->mesh;
  for (std::size_t p = 0; p < mesh.p.points.size(); ++p) {
    const std::string& piece =
        draped->made->garment.pieces[static_cast<std::size_t>(mesh.p.piece_of_point[p])].drawn_name;
    const Vec3 at = draped->drape.positions[static_cast<std::size_t>(mesh.s.s_of_p[p])];
    if (piece == "front") front += at.y, ++fronts;
    if (piece == "back") back += at.y, ++backs;
  }
  EXPECT_LT(front / fronts, back / backs - 0.05);
}

}  // namespace
}  // namespace toile::test
