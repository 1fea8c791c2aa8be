// DXF of a pattern, read back by group codes: true sizes, a block a piece, layers as the apparel standards have them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "runtime/export/export.hpp"
#include "tests/compiler/pattern/drafting.hpp"
#include "tests/runtime/export/read_back.hpp"

namespace toile {
namespace {

using namespace toile::test;

struct Group {
  int code = 0;
  std::string value;
};

std::vector<Group> groups_of(const std::string& dxf) {
  std::vector<Group> groups;
  std::istringstream in(dxf);
  for (std::string code, value; std::getline(in, code) && std::getline(in, value);) {
    groups.push_back({std::stoi(code), value});
  }
  return groups;
}

struct Drawn {
  std::string block, kind, layer, text;
  std::vector<Vec2> points;  // mm
  bool closed = false;
};

/// The entities in order; vertices are taken by their polyline.
std::vector<Drawn> drawn(const std::string& dxf) {
  std::vector<Drawn> all;
  std::string block, kind;
  for (const Group& group : groups_of(dxf)) {
    if (group.code == 0) {
      kind = group.value;
      if (kind == "ENDBLK") block.clear();
      if (kind != "VERTEX") all.push_back({block, kind, "", "", {}, false});
      continue;
    }
    Drawn& last = all.back();
    if (kind == "BLOCK" && group.code == 2) block = group.value;
    if (group.code == 8) last.layer = group.value;
    if (group.code == 1) last.text = group.value;
    if (group.code == 70 && kind == "POLYLINE") last.closed = group.value == "1";
    if (kind == "POLYLINE") continue;
    if (group.code == 10) last.points.push_back({std::stod(group.value), 0});
    if (group.code == 20) last.points.back().y = std::stod(group.value);
  }
  return all;
}

std::vector<Drawn> of_layer(const std::string& dxf, const std::string& kind, const std::string& layer) {
  std::vector<Drawn> found;
  for (const Drawn& each : drawn(dxf)) {
    if (each.kind == kind && each.layer == layer) found.push_back(each);
  }
  return found;
}

TEST(PatternDxf, HasABlockForEachPieceAtTrueScaleInMillimetres) {
  DraftPiece cloth = rectangle("cloth", 0.5, 0.3);
  cloth.allowances = {{"", 0.01, {}}};
  const std::string dxf = pattern_dxf(make(garment({cloth, rectangle("belt", 0.9, 0.05)})).garment);
  const std::vector<Drawn> cut = of_layer(dxf, "POLYLINE", "1");
  ASSERT_EQ(cut.size(), 2U);
  EXPECT_EQ(cut[0].block, "cloth_1");
  EXPECT_EQ(cut[1].block, "belt_2");
  EXPECT_TRUE(cut[0].closed);
  double left = 1e9, right = -1e9;
  for (const Vec2 p : cut[0].points) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
  }
  EXPECT_NEAR(right - left, 520, 1e-3);
  EXPECT_EQ(of_layer(dxf, "INSERT", "1").size(), 2U);
  const std::vector<Drawn> sewn = of_layer(dxf, "POLYLINE", "14");
  ASSERT_EQ(sewn.size(), 8U);
  EXPECT_NEAR(norm(sewn[0].points.back() - sewn[0].points.front()), 500, 1e-3);
}

TEST(PatternDxf, PutsDartsNotchesGrainAndDrillHolesOnTheirLayers) {
  DraftPiece front = rectangle("front", 0.5, 0.3);
  front.darts = {{"dart", front.outline[0].name, 0.25, 0.02, 0.1, {}}};
  front.notches = {{front.outline[1].name, 0.1, {}}};
  front.spots = {{PointMark::Kind::Drill, {0.4, 0.2}, 0, 0, {}}};
  const std::string dxf = pattern_dxf(make(garment({front})).garment);
  EXPECT_EQ(of_layer(dxf, "POLYLINE", "8").size(), 2U);  // the legs
  EXPECT_EQ(of_layer(dxf, "POINT", "4").size(), 1U);
  EXPECT_EQ(of_layer(dxf, "POINT", "13").size(), 2U);  // the tip of the dart, the hole
  const std::vector<Drawn> grain = of_layer(dxf, "LINE", "7");
  ASSERT_EQ(grain.size(), 1U);
  const std::vector<Drawn> corners = of_layer(dxf, "POINT", "2");
  EXPECT_EQ(corners.size(), 4U);
}

TEST(PatternDxf, IsPlainTextEvenWhereNamesAreNot) {
  DraftPiece cloth = rectangle("ärmel", 0.5, 0.3);
  cloth.label = "zweimal, für links\nund rechts";
  const std::string dxf = pattern_dxf(make(garment({cloth})).garment);
  for (const char c : dxf) EXPECT_TRUE(c == '\n' || (c >= ' ' && c < 0x7f));
  std::vector<std::string> texts;
  for (const Drawn& text : of_layer(dxf, "TEXT", "1")) texts.push_back(text.text);
  EXPECT_THAT(texts, testing::Contains("Piece Name: \\U+00E4rmel"));
  EXPECT_THAT(texts, testing::Contains("Annotation: zweimal, f\\U+00FCr links und rechts"));
}

}  // namespace
}  // namespace toile
