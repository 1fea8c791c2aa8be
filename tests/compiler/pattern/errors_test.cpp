// What is wrong with a pattern is said at all places concerned, in garment words.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/compiler/pattern/drafting.hpp"

namespace toile {
namespace {

using namespace toile::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

bool shows(const Diagnostic& diagnostic, Location place) {
  return std::any_of(diagnostic.labels.begin(), diagnostic.labels.end(),
                     [&](const Label& label) { return label.at == place; });
}

/// The one diagnostic of a garment, which must be an error of that code with a primary label.
Diagnostic only_error(const DraftGarment& draft, const std::string& code) {
  const Made made = make(draft);
  EXPECT_EQ(codes(made), std::vector<std::string>{code}) << complaints(made);
  if (made.diagnostics.size() != 1) return {};
  EXPECT_EQ(made.diagnostics[0].severity, Severity::Error);
  EXPECT_TRUE(!made.diagnostics[0].labels.empty() && made.diagnostics[0].labels[0].primary);
  return made.diagnostics[0];
}

DraftGarment two_rectangles(double one, double other) {
  return garment({rectangle("front", 0.3, one), rectangle("back", 0.3, other)}, {sew({"front.right"}, {"back.right"})});
}

TEST(OutlineErrors, OpenOutlineGivesTheGapAndBothEnds) {
  DraftPiece piece = rectangle("front", 0.3, 0.5);
  piece.outline[3].curve = line({0, 0.5}, {0, 0.012});
  const Diagnostic found = only_error(garment({piece}), "E0301");
  EXPECT_THAT(found.message, HasSubstr("a gap of 1.2 cm between the end of `left` and the start of `bottom`"));
  EXPECT_TRUE(shows(found, piece.outline[3].written));
  EXPECT_TRUE(shows(found, piece.outline[0].written));
  EXPECT_THAT(found.help, HasSubstr("to start"));
}

TEST(OutlineErrors, CrossingNamesBothEdgesAndThePlace) {
  const DraftPiece piece = polygon("front", {{0, 0}, {0.4, 0.4}, {0.4, 0}, {0, 0.3}}, {"a", "b", "c", "d"});
  const Diagnostic found = only_error(garment({piece}), "E0302");
  EXPECT_THAT(found.message, HasSubstr("`a` and `c` meet at (17.14 cm, 17.14 cm)"));
  EXPECT_TRUE(shows(found, piece.outline[0].written));
  EXPECT_TRUE(shows(found, piece.outline[2].written));
}

TEST(OutlineErrors, LoopInOneEdge) {
  DraftPiece piece;
  piece.name = "front";
  piece.outline = {edge("hem", bezier({0, 0}, {0.6, -0.4}, {-0.2, -0.4}, {0.4, 0})),
                   edge("top", line({0.4, 0}, {0, 0}))};
  EXPECT_THAT(only_error(garment({piece}), "E0302").message, HasSubstr("edge `hem` of piece `front` crosses itself"));
}

TEST(OutlineErrors, EdgeWithoutLength) {
  const DraftPiece piece = polygon("front", {{0, 0}, {0.4, 0}, {0.4, 0}, {0, 0.3}}, {"a", "b", "c", "d"});
  const Diagnostic found = only_error(garment({piece}), "E0303");
  EXPECT_THAT(found.message, HasSubstr("`b`"));
  EXPECT_TRUE(shows(found, piece.outline[1].written));
}

TEST(OutlineErrors, NothingInside) {
  only_error(garment({polygon("front", {{0, 0}, {0.4, 0}, {0.8, 1e-6}}, {"a", "b", "c"})}), "E0304");
  DraftPiece empty;
  empty.name = "front";
  only_error(garment({empty}), "E0304");
}

TEST(OutlineErrors, LengthsThatAreNoLengths) {
  DraftPiece piece = rectangle("front", 0.3, 0.5);
  piece.outline[1].curve = line({0.3, 0}, {std::numeric_limits<double>::quiet_NaN(), 0.5});
  only_error(garment({piece}), "E0324");
  only_error(garment({rectangle("front", 5000, 2000)}), "E0324");
}

TEST(OutlineErrors, TwoEdgesOfOneName) {
  const DraftPiece piece = polygon("front", {{0, 0}, {0.4, 0}, {0.4, 0.4}}, {"a", "b", "a"});
  const Diagnostic found = only_error(garment({piece}), "E0102");
  EXPECT_TRUE(shows(found, piece.outline[0].written));
  EXPECT_TRUE(shows(found, piece.outline[2].written));
}

TEST(OutlineErrors, GarmentWithoutPieces) {
  only_error(garment({}), "E0325");
}

TEST(FoldErrors, FoldThatIsNotStraight) {
  DraftPiece piece = rectangle("front", 0.3, 0.5);
  piece.outline[3].curve = arc_of_radius({0, 0.5}, {0, 0}, 2);
  piece = folded(piece, "left");
  const Diagnostic found = only_error(garment({piece}), "E0306");
  EXPECT_THAT(found.message, HasSubstr("not straight"));
  EXPECT_TRUE(shows(found, piece.fold_written));
  EXPECT_TRUE(shows(found, piece.outline[3].written));
}

TEST(FoldErrors, ClothBeyondTheFold) {
  const DraftPiece piece = folded(
      polygon("front", {{0, 0}, {0.3, 0}, {0.3, 0.8}, {-0.05, 0.7}, {0, 0.5}}, {"a", "b", "c", "d", "fold"}), "fold");
  const Diagnostic found = only_error(garment({piece}), "E0307");
  EXPECT_THAT(found.message, HasSubstr("reaches 5 cm over the fold line"));
}

TEST(FoldErrors, EdgeAlongTheFoldLine) {
  const DraftPiece piece =
      folded(polygon("front", {{0, 0}, {0.3, 0}, {0.3, 0.8}, {0, 0.8}, {0, 0.6}, {0.1, 0.5}, {0, 0.4}},
                     {"a", "b", "c", "on_the_line", "d", "e", "fold"}),
             "fold");
  EXPECT_THAT(only_error(garment({piece}), "E0307").message, HasSubstr("meets its own other half"));
}

TEST(FoldErrors, UnknownFoldSuggestsTheNearestEdge) {
  const Diagnostic found = only_error(garment({folded(rectangle("front", 0.3, 0.5), "lefft")}), "E0308");
  EXPECT_THAT(found.help, HasSubstr("`left`"));
}

TEST(FoldErrors, FoldedAndMirrored) {
  only_error(garment({paired(folded(rectangle("front", 0.3, 0.5), "left"))}), "E0323");
}

TEST(FoldErrors, FoldCannotBeSewnOrWorn) {
  const DraftPiece front = folded(rectangle("front", 0.3, 0.5), "left");
  const Diagnostic sewn =
      only_error(garment({front, rectangle("back", 0.3, 0.5)}, {sew({"front.left"}, {"back.left"})}), "E0315");
  EXPECT_THAT(sewn.message, HasSubstr("cannot be sewn"));
  EXPECT_TRUE(shows(sewn, front.fold_written));
  EXPECT_THAT(only_error(garment({front}, {}, {wear({"front.left"}, "waist")}), "E0315").message, HasSubstr("worn"));
}

TEST(DartErrors, DeeperThanItsPiece) {
  DraftPiece piece = rectangle("front", 0.3, 0.1);
  piece.darts = {dart("d", "top", 0.15, 0.03, 0.12)};
  const Diagnostic found = only_error(garment({piece}), "E0311");
  ASSERT_FALSE(found.labels.empty());
  EXPECT_THAT(found.labels[0].text, HasSubstr("12 cm deep, where the piece is 10 cm deep"));
}

TEST(DartErrors, CrossesAnotherEdgeOrTheFold) {
  DraftPiece notched = polygon("front", {{0, 0}, {0.3, 0}, {0.3, 0.5}, {0, 0.5}, {0, 0.3}, {0.148, 0.3}, {0, 0.29}},
                               {"bottom", "right", "top", "left", "in", "out", "below"});
  notched.darts = {dart("d", "top", 0.15, 0.1, 0.3)};
  EXPECT_THAT(only_error(garment({notched}), "E0311").message, HasSubstr("crosses edge"));
  DraftPiece half = polygon("front", {{0, 0}, {0.1, 0}, {0.3, 0.5}, {0.2, 0.5}}, {"bottom", "right", "top", "fold"});
  half.darts = {dart("d", "right", 0.3, 0.02, 0.25)};
  only_error(garment({folded(half, "fold")}), "E0311");
}

TEST(DartErrors, WiderThanItsPlace) {
  DraftPiece piece = rectangle("front", 0.3, 0.5);
  piece.darts = {dart("d", "top", 0.01, 0.03, 0.1)};
  const Diagnostic off = only_error(garment({piece}), "E0310");
  EXPECT_TRUE(shows(off, piece.darts[0].written));
  EXPECT_TRUE(shows(off, piece.outline[2].written));
  piece.darts = {dart("d", "top", 0.15, 0.4, 0.1)};
  EXPECT_THAT(only_error(garment({piece}), "E0310").labels[0].text, HasSubstr("40 cm wide on an edge of 30 cm"));
}

TEST(DartErrors, OverlapOnOneEdgeOrAcrossTheCorner) {
  DraftPiece piece = rectangle("front", 0.3, 0.5);
  piece.darts = {dart("d", "top", 0.1, 0.03, 0.1), dart("e", "top", 0.12, 0.03, 0.1)};
  const Diagnostic found = only_error(garment({piece}), "E0312");
  EXPECT_TRUE(shows(found, piece.darts[0].written));
  EXPECT_TRUE(shows(found, piece.darts[1].written));
  piece.darts = {dart("d", "top", 0.1, 0.03, 0.2), dart("e", "right", 0.4, 0.03, 0.25)};
  only_error(garment({piece}), "E0312");
}

TEST(DartErrors, OnTheFold) {
  DraftPiece piece = folded(rectangle("front", 0.3, 0.5), "left");
  piece.darts = {dart("d", "left", 0.2, 0.03, 0.1)};
  only_error(garment({piece}), "E0315");
}

TEST(NotchErrors, OffItsEdgeOrInADart) {
  DraftPiece piece = rectangle("front", 0.3, 0.5);
  piece.notches = {{"top", 0.31, next_place()}};
  EXPECT_THAT(only_error(garment({piece}), "E0313").labels[1].text, HasSubstr("30 cm"));
  piece.notches = {{"top", 0.15, next_place()}};
  piece.darts = {dart("d", "top", 0.15, 0.03, 0.1)};
  EXPECT_THAT(only_error(garment({piece}), "E0313").message, HasSubstr("mouth of a dart"));
}

TEST(HoleErrors, OutsideOrCrossing) {
  DraftPiece piece = rectangle("front", 0.3, 0.5);
  piece.holes = {{"eye", {edge("rim", circle({0.5, 0.2}, {0.52, 0.2}))}, next_place()}};
  EXPECT_THAT(only_error(garment({piece}), "E0314").message, HasSubstr("outside"));
  piece.holes = {{"eye", {edge("rim", circle({0.29, 0.2}, {0.25, 0.2}))}, next_place()}};
  EXPECT_THAT(only_error(garment({piece}), "E0314").message, HasSubstr("meets edge `right`"));
}

TEST(SeamErrors, UnknownEdgeAndPieceSuggestTheNearest) {
  DraftGarment draft = two_rectangles(0.5, 0.5);
  draft.seams[0].second[0].edge = "rihgt";
  draft.seams[0].first[0].piece = "fornt";
  const Made made = make(draft);
  EXPECT_THAT(codes(made), ElementsAre("E0309", "E0308"));
  EXPECT_THAT(made.diagnostics[0].help, HasSubstr("`front`"));
  EXPECT_THAT(made.diagnostics[1].help, HasSubstr("`right`"));
}

TEST(SeamErrors, LengthsDifferGivesBothAndASuggestion) {
  const DraftGarment draft = two_rectangles(0.6, 0.592);
  const Diagnostic found = only_error(draft, "E0316");
  EXPECT_EQ(found.message, "seam lengths differ by 0.8 cm: `front.right` is 60 cm long, `back.right` is 59.2 cm");
  EXPECT_THAT(found.help, HasSubstr("`ease 0.8cm`"));
  EXPECT_THAT(found.help, HasSubstr("make `back.right` 0.8 cm longer"));
  for (const Location place : {draft.seams[0].first[0].written, draft.seams[0].second[0].written,
                               draft.pieces[0].outline[1].written, draft.pieces[1].outline[1].written}) {
    EXPECT_TRUE(shows(found, place));
  }
}

TEST(SeamErrors, FoldedPiecesReportTheirTwoSeamsOnce) {
  only_error(garment({folded(rectangle("front", 0.3, 0.5), "left"), folded(rectangle("back", 0.3, 0.6), "left")},
                     {sew({"front.right"}, {"back.right"})}),
             "E0316");
}

TEST(SeamErrors, EdgeSewnTwiceShowsBothSeams) {
  DraftGarment draft = two_rectangles(0.5, 0.5);
  draft.pieces.push_back(rectangle("pocket", 0.1, 0.5));
  draft.seams.push_back(sew({"pocket.left"}, {"front.right"}));
  const Diagnostic found = only_error(draft, "E0317");
  EXPECT_TRUE(shows(found, draft.seams[0].written));
  EXPECT_TRUE(shows(found, draft.seams[1].written));
  EXPECT_TRUE(shows(found, draft.pieces[0].outline[1].written));
}

TEST(SeamErrors, EdgeGluedOntoItself) {
  only_error(garment({rectangle("front", 0.3, 0.5)}, {sew({"front.top"}, {"front.top"}, true)}), "E0321");
}

TEST(SeamErrors, CopyThatDoesNotExist) {
  only_error(garment({rectangle("front", 0.3, 0.5), rectangle("back", 0.3, 0.5)},
                     {sew({"front.right.mirrored"}, {"back.right"})}),
             "E0322");
}

TEST(WearErrors, WornTwice) {
  const DraftGarment draft =
      garment({rectangle("front", 0.3, 0.5)}, {}, {wear({"front.top"}, "waist"), wear({"front.top"}, "hip")});
  const Diagnostic found = only_error(draft, "E0318");
  EXPECT_TRUE(shows(found, draft.wears[0].written));
  EXPECT_TRUE(shows(found, draft.wears[1].written));
}

TEST(WearErrors, NotContinuousOnceSewn) {
  DraftGarment draft = two_rectangles(0.5, 0.5);
  draft.wears = {wear({"front.top", "back.left"}, "waist")};
  const Diagnostic found = only_error(draft, "E0319");
  EXPECT_THAT(found.message, HasSubstr("`front.top` does not run on into `back.left`"));
}

TEST(TieErrors, PieceThatNothingHolds) {
  DraftGarment draft = two_rectangles(0.5, 0.5);
  draft.pieces.push_back(rectangle("pocket", 0.1, 0.1));
  const Diagnostic found = only_error(draft, "E0320");
  EXPECT_THAT(found.message, HasSubstr("`pocket`"));
  EXPECT_TRUE(shows(found, draft.pieces[2].written));
}

TEST(TieErrors, NothingWornAtAllIsFine) {
  EXPECT_EQ(complaints(make(garment({rectangle("cloth", 1, 1)}))), "");
}

TEST(TieErrors, SewnTogetherButNotToTheWornOnes) {
  DraftGarment draft = two_rectangles(0.5, 0.5);
  draft.pieces.push_back(rectangle("yoke", 0.3, 0.1));
  draft.wears = {wear({"yoke.top"}, "waist")};
  EXPECT_THAT(only_error(draft, "E0320").message, HasSubstr("pieces `front` and `back`"));
}

TEST(Errors, OnesOfDifferentPiecesAreReportedTogether) {
  DraftPiece open = rectangle("front", 0.3, 0.5);
  open.outline[3].curve = line({0, 0.5}, {0, 0.1});
  DraftPiece deep = rectangle("back", 0.3, 0.5);
  deep.darts = {dart("d", "top", 0.1, 0.03, 0.9)};
  const Made made = make(garment({open, deep}, {sew({"front.right"}, {"back.rihgt"})}, {wear({"front.top"}, "waist")}));
  EXPECT_THAT(codes(made), ElementsAre("E0301", "E0311", "E0308"));
}

}  // namespace
}  // namespace toile
