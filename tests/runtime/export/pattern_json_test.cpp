// The pattern as JSON: what stands in it is what the garment says, in metres.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/pattern/region.hpp"
#include "runtime/export/export.hpp"
#include "tests/compiler/pattern/any_piece.hpp"
#include "tests/compiler/pattern/drafting.hpp"

namespace toile {
namespace {

using namespace toile::test;
using Json = nlohmann::json;

TEST(PatternJson, HoldsPiecesSeamsAndWornLines) {
  const Garment skirt = make(flared_skirt()).garment;
  const Json json = Json::parse(pattern_json(skirt));
  EXPECT_EQ(json["garment"].get<std::string>(), skirt.name);
  ASSERT_EQ(json["pieces"].size(), 2u);
  const Json& front = json["pieces"][0];
  EXPECT_EQ(front["edges"].size(), skirt.pieces[0].edges.size());
  EXPECT_EQ(front["darts"].size(), 2u);
  EXPECT_EQ(front["notches"].size(), 4u);
  EXPECT_EQ(front["fold_m"].size(), 2u);
  ASSERT_EQ(json["seams"].size(), 6u);
  EXPECT_TRUE(json["seams"][0]["dart"]);
  const Json& side = json["seams"][4];
  EXPECT_EQ(side["name"].get<std::string>(), "front.side to back.side.mirrored");
  EXPECT_NEAR(side["first"]["length_m"], std::hypot(0.14, 0.612), 1e-9);
  EXPECT_NEAR(side["second"]["length_m"], std::hypot(0.14, 0.612), 1e-9);
  EXPECT_FALSE(side["second"]["links"][0]["forward"]);
  EXPECT_EQ(json["wears"][0]["line"].get<std::string>(), "waist");
  EXPECT_EQ(json["wears"][0]["chain"]["links"].size(), 8u);
}

TEST(PatternJson, KeepsCurvesExactAndAreasWithoutHoles) {
  DraftPiece disc;
  disc.name = "disc";
  disc.outline = {edge("rim", circle({0, 0}, {0.2, 0}))};
  disc.holes = {{"eye", {edge("eye_rim", circle({0, 0}, {0.1, 0}))}, next_place()}};
  const Json piece = Json::parse(pattern_json(make(garment({disc})).garment))["pieces"][0];
  const double pi = 3.14159265358979;
  EXPECT_NEAR(piece["area_m2"], pi * (0.04 - 0.01), 1e-9);
  const Json& arc = piece["edges"][0]["segments"][0];
  EXPECT_EQ(arc["kind"].get<std::string>(), "arc");
  EXPECT_EQ(arc["radius_m"].get<double>(), 0.2);
  EXPECT_NEAR(arc["sweep_rad"], 2 * pi, 1e-9);
  EXPECT_NEAR(piece["holes"][0][0]["segments"][0]["sweep_rad"], -2 * pi, 1e-9);
}

Vec2 point_of(const Json& json) {
  return {json[0], json[1]};
}

Curve curve_of(const Json& segments) {
  std::vector<Segment> read;
  for (const Json& json : segments) {
    if (json["kind"] == "line") {
      read.emplace_back(LineSegment{point_of(json["from_m"]), point_of(json["to_m"])});
    } else if (json["kind"] == "arc") {
      read.emplace_back(ArcSegment{point_of(json["centre_m"]), json["radius_m"], json["start_rad"], json["sweep_rad"]});
    } else {
      const Json& points = json["points_m"];
      read.emplace_back(
          BezierSegment{point_of(points[0]), point_of(points[1]), point_of(points[2]), point_of(points[3])});
    }
  }
  return Curve(read);
}

TEST(PatternJson, ReadsBackAsTheSamePiecesWhateverTheyAre) {
  int compared = 0;
  EXPECT_TRUE(rc::check([&] {
    const Garment made = make(garment({any_piece("a")})).garment;
    const Json json = Json::parse(pattern_json(made));
    RC_ASSERT(json["pieces"].size() == made.pieces.size());
    for (std::size_t i = 0; i < made.pieces.size(); ++i) {
      const Piece& piece = made.pieces[i];
      const Json& read = json["pieces"][i];
      RC_ASSERT(read["name"] == piece.name);
      RC_ASSERT(read["edges"].size() == piece.edges.size());
      std::vector<Curve> curves;
      for (std::size_t k = 0; k < piece.edges.size(); ++k) {
        const Json& edge = read["edges"][k];
        curves.push_back(curve_of(edge["segments"]));
        RC_ASSERT(edge["name"] == piece.edges[k].name);
        RC_ASSERT(std::abs(curves.back().length() - piece.edges[k].curve.length()) < 1e-9);
        RC_ASSERT(distance(curves.back().end(), piece.edges[k].curve.end()) < 1e-9);
      }
      RC_ASSERT(std::abs(signed_area(join(curves)) - signed_area(whole_outline(piece.edges))) < 1e-9);
      ++compared;
    }
  }));
  EXPECT_GT(compared, 20);
}

TEST(PatternJson, SameGarmentSameBytes) {
  const DraftGarment draft = flared_skirt();
  EXPECT_EQ(pattern_json(make(draft).garment), pattern_json(make(draft).garment));
  EXPECT_EQ(pattern_svg(make(draft).garment), pattern_svg(make(draft).garment));
}

}  // namespace
}  // namespace toile
