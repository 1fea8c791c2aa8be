// Holes: their edges are sewn and worn like those of the outline.
#include <algorithm>
#include <numbers>

#include "tests/compiler/pattern/drafting.hpp"

namespace toile {
namespace {

using namespace toile::test;
using std::numbers::pi;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

DraftInner round_hole(std::string name, Vec2 centre, double radius) {
  return {std::move(name), {edge("rim", circle(centre, centre + Vec2{0, radius}))}, next_place()};
}

/// A rectangle of 60 cm by 50 cm with a round hole in its middle.
DraftPiece poncho(double radius = 0.1) {
  DraftPiece piece = rectangle("poncho", 0.6, 0.5);
  piece.holes = {round_hole("neck", {0.3, 0.25}, radius)};
  return piece;
}

TEST(Holes, AreNumberedAfterTheOutline) {
  DraftPiece piece = poncho(0.05);
  piece.holes.push_back({"slot",
                         {edge("left", line({0.1, 0.1}, {0.1, 0.15})), edge("top", line({0.1, 0.15}, {0.15, 0.15})),
                          edge("back", line({0.15, 0.15}, {0.1, 0.1}))},
                         next_place()});
  const Made made = make(garment({piece}));
  ASSERT_EQ(complaints(made), "");
  const Piece& cut = made.garment.pieces[0];
  ASSERT_EQ(cut.edge_count(), 8);
  EXPECT_EQ(cut.edge(3).name, "left");
  EXPECT_EQ(cut.next_edge(3), 0);
  EXPECT_EQ(cut.edge(4).name, "neck.rim");
  EXPECT_EQ(cut.next_edge(4), 4);
  EXPECT_EQ(cut.edge(5).name, "slot.left");
  EXPECT_EQ(cut.next_edge(5), 6);
  EXPECT_EQ(cut.next_edge(7), 5);
}

TEST(Holes, AreWorn) {
  const Made made = make(garment({poncho()}, {}, {wear({"poncho.neck.rim"}, "neck")}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_EQ(described(made.garment, made.garment.wears[0].chain), "poncho.neck.rim");
}

TEST(Holes, AreWalkedWithTheClothOnTheLeft) {
  for (const bool drawn_backwards : {false, true}) {
    DraftPiece piece = poncho();
    if (drawn_backwards) piece.holes[0].edges[0].curve = piece.holes[0].edges[0].curve.reversed();
    const Made made = make(garment({piece}));
    ASSERT_EQ(complaints(made), "");
    const Curve& rim = made.garment.pieces[0].edge(4).curve;
    const Vec2 outwards = rim.at(0.05) - Vec2{0.3, 0.25};
    EXPECT_GT(dot(perpendicular(rim.tangent(0.05)), outwards), 0);
  }
}

TEST(Holes, TakeACollar) {
  DraftPiece collar = rectangle("collar", 2 * pi * 0.1, 0.04);
  const Made made = make(garment({poncho(), collar},
                                 {sew({"collar.left"}, {"collar.right"}), sew({"collar.bottom"}, {"poncho.neck.rim"})},
                                 {wear({"collar.top"}, "neck")}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment),
              ElementsAre("collar.left | -collar.right", "collar.bottom | -poncho.neck.rim"));
  EXPECT_EQ(made.garment.seams[1].name, "collar.bottom to poncho.neck.rim");
}

TEST(Holes, RunOnFromEdgeToEdge) {
  DraftPiece piece = rectangle("poncho", 0.6, 0.5);
  piece.holes = {{"neck",
                  {edge("left", line({0.2, 0.2}, {0.2, 0.3})), edge("top", line({0.2, 0.3}, {0.4, 0.3})),
                   edge("right", line({0.4, 0.3}, {0.4, 0.2})), edge("bottom", line({0.4, 0.2}, {0.2, 0.2}))},
                  next_place()}};
  const Made made = make(garment(
      {piece}, {}, {wear({"poncho.neck.left", "poncho.neck.right", "poncho.neck.top", "poncho.neck.bottom"}, "neck")}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_EQ(described(made.garment, made.garment.wears[0].chain),
            "poncho.neck.left poncho.neck.top poncho.neck.right poncho.neck.bottom");
}

TEST(Holes, OfOneSideHaveACopyOnTheOther) {
  DraftPiece body = folded(rectangle("body", 0.3, 0.5), "left");
  body.holes = {round_hole("armhole", {0.2, 0.3}, 0.06)};
  DraftPiece sleeve = paired(rectangle("sleeve", 2 * pi * 0.06, 0.4));
  const Made made = make(
      garment({body, sleeve}, {sew({"sleeve.left"}, {"sleeve.right"}), sew({"sleeve.top"}, {"body.armhole.rim"})}));
  ASSERT_EQ(complaints(made), "");
  ASSERT_EQ(made.garment.pieces[0].holes.size(), 2u);
  EXPECT_EQ(made.garment.pieces[0].holes[1][0].side, Side::Mirrored);
  const std::vector<std::string> seams = described_seams(made.garment);
  ASSERT_EQ(seams.size(), 4u);
  EXPECT_EQ(seams[2], "sleeve.top | -body.armhole.rim");
  EXPECT_EQ(seams[3], "sleeve.top.mirrored | -body.armhole.rim.mirrored");
  const Made worn = make(garment({body}, {}, {wear({"body.armhole.rim.mirrored"}, "left_armhole")}));
  ASSERT_EQ(complaints(worn), "");
  EXPECT_EQ(described(worn.garment, worn.garment.wears[0].chain), "body.armhole.rim.mirrored");
}

TEST(Holes, OfAPairAreInBothPieces) {
  DraftPiece half = paired(rectangle("half", 0.3, 0.5));
  half.holes = {round_hole("armhole", {0.2, 0.3}, 0.06)};
  const Made made = make(garment(
      {half}, {sew({"half.left"}, {"half.left"})},
      {wear({"half.armhole.rim.drawn"}, "left_armhole"), wear({"half.armhole.rim.mirrored"}, "right_armhole")}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_EQ(made.garment.wears[1].chain[0].edge.piece, 1);
}

TEST(Holes, OnTheFoldAreRefused) {
  DraftPiece piece = folded(rectangle("front", 0.3, 0.5), "left");
  piece.holes = {round_hole("neck", {0, 0.3}, 0.06)};
  const Made made = make(garment({piece}));
  ASSERT_THAT(codes(made), ElementsAre("E0314"));
  EXPECT_EQ(made.diagnostics[0].message, "hole `neck` lies across the fold `left` of piece `front`");
  EXPECT_THAT(made.diagnostics[0].help, HasSubstr("draw half of it"));
}

DraftPiece with_half_hole(Vec2 from, Vec2 through, Vec2 to) {
  DraftPiece piece = folded(rectangle("front", 0.3, 0.5), "left");
  piece.holes = {{"neck", {edge("rim", arc_through(from, through, to))}, next_place()}};
  return piece;
}

TEST(Holes, OfWhichOneHalfIsDrawnAtTheFoldAreCutWhole) {
  for (const bool upwards : {false, true}) {
    const Vec2 low{0, 0.24}, high{0, 0.36};
    DraftPiece piece = with_half_hole(upwards ? low : high, {0.06, 0.3}, upwards ? high : low);
    piece.notches = {{"neck.rim", 0.05, next_place()}};
    const Made made =
        make(garment({piece, rectangle("collar", 2 * pi * 0.06, 0.04)},
                     {sew({"collar.left"}, {"collar.right"}), sew({"collar.bottom"}, {"front.neck.rim"})}));
    ASSERT_EQ(complaints(made), "");
    const Piece& front = made.garment.pieces[0];
    EXPECT_EQ(front.edges.size(), 6u);
    ASSERT_EQ(front.holes.size(), 1u);
    EXPECT_EQ(front.edge(6).name, "neck.rim");
    EXPECT_EQ(front.edge(7).side, Side::Mirrored);
    EXPECT_EQ(front.next_edge(7), 6);
    EXPECT_NEAR(front.edge(6).curve.length() + front.edge(7).curve.length(), 2 * pi * 0.06, 1e-9);
    for (const int number : {6, 7}) {  // the cloth lies to their left
      const Curve& rim = front.edge(number).curve;
      EXPECT_GT(dot(perpendicular(rim.tangent(0.05)), rim.at(0.05) - Vec2{0, 0.3}), 0);
    }
    ASSERT_EQ(front.notches.size(), 2u);
    const auto height = [&](const Notch& notch) { return front.edge(notch.edge).curve.at(notch.at).y; };
    EXPECT_NEAR(height(front.notches[0]), height(front.notches[1]), 1e-9);
    ASSERT_TRUE(front.fold);
    EXPECT_NEAR(distance(front.fold->from, front.fold->to), 0.5, 1e-12);
  }
}

TEST(Holes, SeveralLieOnTheFoldBesideOthers) {
  DraftPiece piece = with_half_hole({0, 0.24}, {0.06, 0.3}, {0, 0.36});
  piece.holes.push_back({"slot",
                         {edge("low", line({0, 0.1}, {0.02, 0.1})), edge("up", line({0.02, 0.1}, {0.02, 0.15})),
                          edge("top", line({0.02, 0.15}, {0, 0.15}))},
                         next_place()});
  piece.holes.push_back(round_hole("eye", {0.2, 0.2}, 0.03));
  const Made made = make(garment({piece}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_EQ(made.garment.pieces[0].holes.size(), 4u);
  EXPECT_EQ(made.garment.pieces[0].edge_count(), 6 + 2 + 6 + 2);
}

TEST(Holes, OnTheFoldKeepToTheClothAndToThemselves) {
  const DraftPiece beyond = with_half_hole({0, 0.24}, {-0.06, 0.3}, {0, 0.36});
  EXPECT_THAT(codes(make(garment({beyond}))), ElementsAre("E0314"));
  const DraftPiece at_the_hem = with_half_hole({0, 0.02}, {0.06, -0.01}, {0, 0.12});
  EXPECT_THAT(codes(make(garment({at_the_hem}))), ElementsAre("E0314"));
  DraftPiece nested = with_half_hole({0, 0.2}, {0.1, 0.3}, {0, 0.4});
  nested.holes.push_back({"inner", {edge("rim", arc_through({0, 0.28}, {0.02, 0.3}, {0, 0.32}))}, next_place()});
  EXPECT_THAT(codes(make(garment({nested}))), ElementsAre("E0314"));
}

TEST(Holes, LengthsAreCheckedAsAnywhere) {
  DraftGarment draft = garment({poncho(), rectangle("collar", 0.6, 0.04)},
                               {sew({"collar.left"}, {"collar.right"}), sew({"collar.bottom"}, {"poncho.neck.rim"})});
  const Made made = make(draft);
  ASSERT_THAT(codes(made), ElementsAre("E0316"));
  EXPECT_EQ(made.diagnostics[0].message,
            "seam lengths differ by 2.83 cm: `collar.bottom` is 60 cm long, `poncho.neck.rim` is 62.83 cm");
  const Location rim = draft.pieces[0].holes[0].edges[0].written;
  EXPECT_TRUE(std::any_of(made.diagnostics[0].labels.begin(), made.diagnostics[0].labels.end(),
                          [&](const Label& label) { return label.at == rim; }));
  draft.seams[1].fullness = Seam::Fullness::Ease;
  draft.seams[1].stated = 0.03;
  EXPECT_EQ(complaints(make(draft)), "");
}

TEST(Holes, AreSewnAndWornOnce) {
  EXPECT_THAT(codes(make(garment({poncho(), rectangle("a", 2 * pi * 0.1, 0.04), rectangle("b", 2 * pi * 0.1, 0.04)},
                                 {sew({"a.bottom"}, {"poncho.neck.rim"}), sew({"b.bottom"}, {"poncho.neck.rim"})}))),
              ElementsAre("E0317"));
  EXPECT_THAT(
      codes(make(garment({poncho()}, {}, {wear({"poncho.neck.rim"}, "neck"), wear({"poncho.neck.rim"}, "bust")}))),
      ElementsAre("E0318"));
}

TEST(Holes, AreFoundBehindTheirNames) {
  const auto told = [](DraftPiece piece, const char* reference) {
    const Made made = make(garment({std::move(piece)}, {}, {wear({reference}, "neck")}));
    EXPECT_THAT(codes(made), ElementsAre("E0308"));
    return made.diagnostics.empty() ? "" : made.diagnostics[0].help;
  };
  EXPECT_EQ(told(poncho(), "poncho.rim"), "write `poncho.neck.rim`");
  EXPECT_THAT(told(poncho(), "poncho.neck.rm"), HasSubstr("`neck.rim`"));
  DraftPiece unnamed = poncho();
  unnamed.holes[0].name = "";
  EXPECT_THAT(told(unnamed, "poncho.rim"), HasSubstr("give the hole a name"));
}

TEST(Holes, HaveNamesOfTheirOwn) {
  DraftPiece piece = poncho(0.05);
  piece.holes[0].name = "left";
  EXPECT_THAT(codes(make(garment({piece}))), ElementsAre("E0102"));
  piece.holes[0].name = "eye";
  piece.holes.push_back(round_hole("eye", {0.1, 0.1}, 0.03));
  EXPECT_THAT(codes(make(garment({piece}))), ElementsAre("E0102"));
  piece.holes[1].name = "other";
  EXPECT_EQ(complaints(make(garment({piece}))), "");
}

}  // namespace
}  // namespace toile
