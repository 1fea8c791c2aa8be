// From drawn outlines to cut pieces: direction, fold, mirrored pairs, darts, notches, allowances.
#include <algorithm>

#include "compiler/pattern/region.hpp"
#include "tests/compiler/pattern/drafting.hpp"

namespace toile {
namespace {

using namespace toile::test;
using ::testing::ElementsAre;

void expect_closed_and_ccw(const Piece& piece) {
  for (std::size_t i = 0; i < piece.edges.size(); ++i) {
    const Curve& next = piece.edges[(i + 1) % piece.edges.size()].curve;
    EXPECT_LT(distance(piece.edges[i].curve.end(), next.start()), 1e-9) << piece.name << " edge " << i;
  }
  const Curve outline = whole_outline(piece.edges);
  EXPECT_GT(signed_area(outline), 0) << piece.name;
  EXPECT_TRUE(self_crossings(outline).empty()) << piece.name;
}

std::vector<std::string> edge_names(const Piece& piece) {
  std::vector<std::string> names;
  for (const PieceEdge& e : piece.edges) {
    names.push_back(e.name + (e.part > 0 ? "#" + std::to_string(e.part) : "") + (e.side == Side::Mirrored ? "'" : ""));
  }
  return names;
}

TEST(Outline, EitherDirectionOfDrawingGivesTheSamePiece) {
  const DraftPiece left = polygon("p", {{0, 0}, {1, 0}, {1, 2}}, {"a", "b", "c"});
  const DraftPiece right = polygon("p", {{0, 0}, {1, 2}, {1, 0}}, {"c", "b", "a"});
  const Made one = make(garment({left})), other = make(garment({right}));
  ASSERT_EQ(complaints(one) + complaints(other), "");
  expect_closed_and_ccw(one.garment.pieces[0]);
  expect_closed_and_ccw(other.garment.pieces[0]);
  EXPECT_THAT(edge_names(one.garment.pieces[0]), ElementsAre("a", "b", "c"));
  EXPECT_THAT(edge_names(other.garment.pieces[0]), ElementsAre("a", "b", "c"));
}

TEST(Fold, UnfoldsToBothHalves) {
  const Made made = make(garment({folded(rectangle("p", 0.3, 0.5), "left")}));
  ASSERT_EQ(complaints(made), "");
  const Piece& piece = made.garment.pieces[0];
  expect_closed_and_ccw(piece);
  EXPECT_THAT(edge_names(piece), ElementsAre("bottom", "right", "top", "top'", "right'", "bottom'"));
  EXPECT_NEAR(signed_area(whole_outline(piece.edges)), 2 * 0.3 * 0.5, 1e-12);
  ASSERT_TRUE(piece.fold);
  EXPECT_NEAR(distance(piece.fold->from, piece.fold->to), 0.5, 1e-12);
}

TEST(Fold, SlantedFoldMirrorsAllThatIsOnThePiece) {
  DraftPiece half = polygon("p", {{0, 0}, {0.3, 0.3}, {0.1, 0.5}}, {"fold", "top", "side"});
  half.darts = {dart("d", "top", 0.1, 0.02, 0.05)};
  half.notches = {{"side", 0.1, next_place()}};
  half.holes = {{"eye", {edge("rim", circle({0.13, 0.25}, {0.14, 0.25}))}, next_place()}};
  const Made made = make(garment({folded(half, "fold")}));
  ASSERT_EQ(complaints(made), "");
  const Piece& piece = made.garment.pieces[0];
  expect_closed_and_ccw(piece);
  ASSERT_EQ(piece.darts.size(), 2u);
  ASSERT_EQ(piece.notches.size(), 2u);
  ASSERT_EQ(piece.holes.size(), 2u);
  const auto mirror = [](Vec2 p) { return Vec2{p.y, p.x}; };  // in the line y = x
  EXPECT_LT(distance(mirror(piece.darts[0].tip), piece.darts[1].tip), 1e-12);
  const auto at = [&](const Notch& n) { return piece.edges[n.edge].curve.at(n.at); };
  EXPECT_LT(distance(mirror(at(piece.notches[0])), at(piece.notches[1])), 1e-12);
  for (const auto& hole : piece.holes) EXPECT_LT(signed_area(whole_outline(hole)), 0);
}

TEST(MirroredPair, IsTwoPiecesOfOnePairEach) {
  DraftPiece drawn = rectangle("sleeve", 0.3, 0.5);
  drawn.warp = direction(-1.0);
  const Made made = make(garment({paired(drawn)}, {sew({"sleeve.left"}, {"sleeve.left"})}));
  ASSERT_EQ(complaints(made), "");
  ASSERT_EQ(made.garment.pieces.size(), 2u);
  const Piece& copy = made.garment.pieces[1];
  EXPECT_EQ(copy.name, "sleeve.mirrored");
  EXPECT_EQ(copy.drawn_name, "sleeve");
  EXPECT_EQ(copy.side, Side::Mirrored);
  EXPECT_EQ(copy.quantity, 1);
  expect_closed_and_ccw(copy);
  EXPECT_THAT(edge_names(copy), ElementsAre("left'", "top'", "right'", "bottom'"));
  EXPECT_NEAR(copy.warp.x, -drawn.warp.x, 1e-12);
  EXPECT_NEAR(copy.warp.y, drawn.warp.y, 1e-12);
}

TEST(Dart, SplitsItsEdgeAndHasEqualLegs) {
  for (const bool clockwise : {false, true}) {
    DraftPiece piece = rectangle("p", 0.4, 0.6);
    if (clockwise) {
      std::reverse(piece.outline.begin(), piece.outline.end());
      for (DraftEdge& e : piece.outline) e.curve = e.curve.reversed();
    }
    piece.darts = {dart("d", "top", 0.1, 0.03, 0.12)};
    const Made made = make(garment({piece}));
    ASSERT_EQ(complaints(made), "");
    const Piece& cut = made.garment.pieces[0];
    expect_closed_and_ccw(cut);
    ASSERT_EQ(cut.darts.size(), 1u);
    const Dart& d = cut.darts[0];
    EXPECT_NEAR(cut.edges[d.left_leg].curve.length(), cut.edges[d.right_leg].curve.length(), 1e-12);
    EXPECT_NEAR(cut.edges[d.left_leg].curve.length(), std::hypot(0.015, 0.12), 1e-12);
    EXPECT_LT(distance(d.tip, {clockwise ? 0.1 : 0.3, 0.48}), 1e-12);
    EXPECT_EQ(cut.edges[d.left_leg].name, "d.left");
    EXPECT_TRUE(cut.edges[d.left_leg].is_dart_leg);
    // Part 0 comes first in the direction of drawing: 8.5 cm up to the dart that stands at 10 cm.
    for (const PieceEdge& e : cut.edges) {
      if (e.name == "top") {
        EXPECT_NEAR(e.curve.length(), e.part == 0 ? 0.085 : 0.285, 1e-12);
      }
    }
    ASSERT_EQ(made.garment.seams.size(), 1u);
    EXPECT_TRUE(made.garment.seams[0].is_dart);
    EXPECT_EQ(described(made.garment, made.garment.seams[0].first), "p.d.left");
    EXPECT_EQ(described(made.garment, made.garment.seams[0].second), "-p.d.right");
  }
}

TEST(Dart, OnACurveStandsOnItsMouthsBisector) {
  DraftPiece piece;
  piece.name = "p";
  piece.outline = {edge("arc", arc_of_radius({0, 0}, {0.4, 0}, 0.5)), edge("right", line({0.4, 0}, {0.4, 0.4})),
                   edge("top", line({0.4, 0.4}, {0, 0.4})), edge("left", line({0, 0.4}, {0, 0}))};
  piece.darts = {dart("d", "arc", 0.1, 0.04, 0.1)};
  const Made made = make(garment({piece}));
  ASSERT_EQ(complaints(made), "");
  const Piece& cut = made.garment.pieces[0];
  const Dart& d = cut.darts[0];
  const Curve &left = cut.edges[d.left_leg].curve, &right = cut.edges[d.right_leg].curve;
  EXPECT_NEAR(left.length(), right.length(), 1e-12);
  EXPECT_NEAR(distance(0.5 * (left.start() + right.end()), d.tip), 0.1, 1e-12);
  EXPECT_NEAR(d.width, 2 * 0.5 * std::sin(0.04 / 0.5 / 2), 1e-12);
}

TEST(Notch, KeepsItsPlaceBehindADart) {
  DraftPiece piece = rectangle("p", 0.4, 0.6);
  piece.darts = {dart("d", "bottom", 0.2, 0.04, 0.1)};
  piece.notches = {{"bottom", 0.05, next_place()}, {"bottom", 0.33, next_place()}};
  const Made made = make(garment({piece}));
  ASSERT_EQ(complaints(made), "");
  const Piece& cut = made.garment.pieces[0];
  ASSERT_EQ(cut.notches.size(), 2u);
  const auto at = [&](const Notch& n) { return cut.edges[n.edge].curve.at(n.at); };
  EXPECT_LT(distance(at(cut.notches[0]), {0.05, 0}), 1e-12);
  EXPECT_LT(distance(at(cut.notches[1]), {0.33, 0}), 1e-12);
}

TEST(Allowance, GeneralOneGivesWayToTheEdgesOwn) {
  const Made made = make(flared_skirt());
  ASSERT_EQ(complaints(made), "");
  for (const PieceEdge& e : made.garment.pieces[0].edges) {
    EXPECT_EQ(e.allowance, e.is_dart_leg ? 0 : e.name == "hem" ? 0.04 : 0.01) << e.name;
  }
}

TEST(FlaredSkirt, IsTwoUnfoldedPanels) {
  const Made made = make(flared_skirt());
  ASSERT_EQ(complaints(made), "");
  ASSERT_EQ(made.garment.pieces.size(), 2u);
  for (const Piece& piece : made.garment.pieces) {
    expect_closed_and_ccw(piece);
    EXPECT_EQ(piece.darts.size(), 2u);
    EXPECT_EQ(piece.notches.size(), 4u);
    EXPECT_EQ(piece.edges.size(), 12u);  // per half: waist in two parts, two legs, side, hem
  }
}

}  // namespace
}  // namespace toile
