// The pattern on paper: true scale, true curves, no piece over another, nothing of XML's left unescaped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/pattern/region.hpp"
#include "runtime/export/cut_line.hpp"
#include "runtime/export/export.hpp"
#include "runtime/export/pattern_layout.hpp"
#include "tests/compiler/pattern/drafting.hpp"

namespace toile {
namespace {

using namespace toile::test;
using ::testing::HasSubstr;

std::vector<std::string> all_between(const std::string& text, const std::string& before, const std::string& after) {
  std::vector<std::string> found;
  for (auto at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    at += before.size();
    found.push_back(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

// Tags open and close in order, and attributes are quoted: what an XML parser would insist on.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (const std::string& tag : all_between(xml, "<", ">")) {
    if (tag[0] == '?' || tag.back() == '/') continue;
    if (tag[0] != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    } else if (open.empty() || open.back() != tag.substr(1)) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

DraftPiece disc(const std::string& name, double radius) {
  DraftPiece piece;
  piece.name = name;
  piece.outline = {edge("rim", circle({0, 0}, {radius, 0}))};
  return piece;
}

TEST(PatternSvg, IsAtTrueScaleInMillimetres) {
  const std::string svg = pattern_svg(make(garment({rectangle("cloth", 0.5, 0.3)})).garment);
  EXPECT_TRUE(well_formed(svg));
  const std::string width = all_between(svg, "width=\"", "mm\"").at(0),
                    height = all_between(svg, "height=\"", "mm\"").at(0);
  EXPECT_THAT(all_between(svg, "viewBox=\"", "\"").at(0), ::testing::EndsWith(" " + width + " " + height));
  EXPECT_THAT(svg, HasSubstr("M0,0L500,0L500,-300L0,-300L0,0Z"));
}

TEST(PatternSvg, KeepsArcsAndBeziers) {
  const std::string rim = pattern_svg(make(garment({disc("disc", 0.15)})).garment);
  EXPECT_THAT(rim, HasSubstr("A150 150 0 0 0 "));  // counter-clockwise on paper, too
  const std::string skirt = pattern_svg(make(flared_skirt()).garment);
  EXPECT_TRUE(well_formed(skirt));
  EXPECT_THAT(all_between(skirt, "class=\"stitch\" d=\"M0,610", "\"").at(0), HasSubstr("C"));
}

TEST(PatternSvg, SaysWhichEdgesAreSewnAndWorn) {
  const std::string svg = pattern_svg(make(flared_skirt()).garment);
  for (const char* sign : {"A", "B"}) {
    int badges = 0;
    for (const std::string& text : all_between(svg, "<text class=\"badge\"", "<")) badges += text.back() == sign[0];
    EXPECT_EQ(badges, 3) << sign;  // both edges and the list of seams
  }
  EXPECT_THAT(svg, HasSubstr("front.side to back.side.mirrored"));
  EXPECT_THAT(svg, HasSubstr("worn at waist"));
  EXPECT_THAT(svg, HasSubstr(">grain<"));
  EXPECT_THAT(svg, HasSubstr(">fold<"));
  EXPECT_EQ(all_between(svg, "class=\"notch\"", "/").size(), 8u);
  EXPECT_EQ(all_between(svg, "class=\"dart\"", "/").size(), 4u);
}

TEST(PatternSvg, EscapesNames) {
  DraftGarment draft = garment({disc("<b> & \"c\"", 0.1)});
  draft.name = "a&b";
  const std::string svg = pattern_svg(make(draft).garment);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("&lt;b&gt; &amp; &quot;c&quot;"));
  EXPECT_THAT(svg, HasSubstr("<title>a&amp;b: flat pattern</title>"));
}

TEST(PatternSvg, EmptyGarmentIsAnEmptySheet) {
  EXPECT_TRUE(well_formed(pattern_svg(Garment{})));
}

TEST(CutLine, LiesOutsideByTheAllowanceWithMitredCorners) {
  DraftPiece piece = rectangle("p", 0.4, 0.3);
  piece.allowances = {{"", 0.01, next_place()}, {"top", 0.04, next_place()}};
  const std::vector<Vec2> cut = cut_line(make(garment({piece})).garment.pieces[0].edges);
  Box box;
  for (const Vec2 point : cut) box.add(point);
  EXPECT_NEAR(box.low.x, -0.01, 1e-12);
  EXPECT_NEAR(box.low.y, -0.01, 1e-12);
  EXPECT_NEAR(box.high.x, 0.41, 1e-12);
  EXPECT_NEAR(box.high.y, 0.34, 1e-12);
  EXPECT_NE(std::find_if(cut.begin(), cut.end(), [](Vec2 p) { return distance(p, {0.41, 0.34}) < 1e-9; }), cut.end());
}

TEST(CutLine, PassesStraightOverDartsAndDoesNotCrossItself) {
  for (const Piece& piece : make(flared_skirt()).garment.pieces) {
    std::vector<Curve> sides;
    const std::vector<Vec2> cut = cut_line(piece.edges);
    for (std::size_t i = 0; i < cut.size(); ++i) sides.push_back(line(cut[i], cut[(i + 1) % cut.size()]));
    EXPECT_TRUE(self_crossings(join(sides)).empty());
    const Region within(join(sides));
    for (const PieceEdge& e : piece.edges) EXPECT_TRUE(within.contains(e.curve.at(e.curve.length() / 2)));
    for (const Dart& d : piece.darts) {
      for (const Vec2 p : cut) EXPECT_GT(distance(p, d.tip), 0.08);
    }
  }
}

TEST(CutLine, SharpCornerIsNotDrawnOutFarther) {
  DraftPiece piece = polygon("p", {{0, 0}, {0.5, -0.02}, {0.5, 0.02}}, {"a", "b", "c"});
  piece.allowances = {{"", 0.01, next_place()}};
  for (const Vec2 point : cut_line(make(garment({piece})).garment.pieces[0].edges)) EXPECT_GT(point.x, -0.02 - 1e-9);
}

TEST(CutLine, InnerCornerIsTrimmed) {
  DraftPiece piece =
      polygon("p", {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0.2, 0.3}, {0.2, 0.1}, {0, 0.1}}, {"a", "b", "c", "d", "e", "f"});
  piece.allowances = {{"", 0.02, next_place()}};
  const std::vector<Vec2> cut = cut_line(make(garment({piece})).garment.pieces[0].edges);
  EXPECT_NE(std::find_if(cut.begin(), cut.end(), [](Vec2 p) { return distance(p, {0.18, 0.12}) < 1e-9; }), cut.end());
  EXPECT_EQ(std::find_if(cut.begin(), cut.end(), [](Vec2 p) { return distance(p, {0.2, 0.12}) < 1e-3; }), cut.end());
}

bool has_corner(const std::vector<Vec2>& line, Vec2 corner) {
  return std::any_of(line.begin(), line.end(), [&](Vec2 p) { return distance(p, corner) < 1e-6; });
}

TEST(CutLine, TurnsItsCornersAsTheyAskForIt) {
  // The side leans outwards by one in two towards the hem.
  DraftPiece piece = polygon("p", {{0, 0}, {0.4, 0}, {0.3, 0.2}, {0, 0.2}}, {"hem", "side", "top", "left"});
  piece.allowances = {{"", 0.01, next_place()}, {"hem", 0.04, next_place(), AllowanceCorner::Mirrored}};
  const double reach = 0.01 * std::sqrt(1.25);  // of the side's allowance along the hem
  const std::vector<Vec2> mirrored = cut_line(make(garment({piece})).garment.pieces[0].edges);
  EXPECT_TRUE(has_corner(mirrored, {0.4 + reach, 0}));
  EXPECT_TRUE(has_corner(mirrored, {0.4 + reach - 0.02, -0.04}));  // leans back as the side does
  piece.allowances[1].corner = AllowanceCorner::Square;
  EXPECT_TRUE(has_corner(cut_line(make(garment({piece})).garment.pieces[0].edges), {0.4 + reach, -0.04}));
  piece.allowances[1].corner = AllowanceCorner::Mitred;
  EXPECT_TRUE(has_corner(cut_line(make(garment({piece})).garment.pieces[0].edges), {0.4 + reach + 0.02, -0.04}));
}

TEST(CutLine, StandsOverADartAsItsFoldedClothNeedsIt) {
  DraftPiece piece = rectangle("p", 0.4, 0.3);
  piece.darts = {dart("d", "top", 0.2, 0.04, 0.15)};
  piece.allowances = {{"", 0.01, next_place()}};
  const auto highest = [](const DraftPiece& draft) {
    double high = 0;
    for (const Vec2 p : cut_line(make(garment({draft})).garment.pieces[0].edges)) high = std::max(high, p.y);
    return high;
  };
  EXPECT_GT(highest(piece), 0.3125);
  piece.darts[0].pressed = Press::Open;
  EXPECT_NEAR(highest(piece), 0.31, 1e-9);
}

TEST(Shelves, PiecesStandApart) {
  std::vector<Box> boxes;
  for (int i = 0; i < 7; ++i) boxes.push_back({{-0.1 * i, 0.3}, {0.2 + 0.05 * i, 0.5 + 0.1 * i}});
  Vec2 size;
  const std::vector<Vec2> shifts = on_shelves(boxes, 0.02, size);
  ASSERT_EQ(shifts.size(), boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec2 low = boxes[i].low + shifts[i], high = boxes[i].high + shifts[i];
    EXPECT_GE(low.x, -1e-12);
    EXPECT_LE(high.x, size.x + 1e-12);
    EXPECT_LE(high.y, 1e-12);
    EXPECT_GE(low.y, -size.y - 1e-12);
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 other_low = boxes[j].low + shifts[j], other_high = boxes[j].high + shifts[j];
      const double apart =
          std::max({low.x - other_high.x, other_low.x - high.x, low.y - other_high.y, other_low.y - high.y});
      EXPECT_GE(apart, 0.02 - 1e-12) << i << " and " << j;
    }
  }
}

TEST(FreeSpot, LiesInThePieceAwayFromFoldAndHoles) {
  DraftPiece half = rectangle("p", 0.2, 0.5);
  half.holes = {{"eye", {edge("rim", circle({0.1, 0.25}, {0.13, 0.25}))}, next_place()}};
  const Piece piece = make(garment({folded(half, "left")})).garment.pieces[0];
  const Spot spot = free_spot(piece, {});
  EXPECT_GT(spot.clearance, 0.05);
  EXPECT_GE(std::abs(spot.at.x), spot.clearance - 1e-9);
  EXPECT_TRUE(Region(whole_outline(piece.edges)).contains(spot.at));
}

}  // namespace
}  // namespace toile
