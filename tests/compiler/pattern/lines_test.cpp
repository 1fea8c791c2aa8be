// Lines inside a piece, and what is sewn upon them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/compiler/pattern/drafting.hpp"

namespace toile {
namespace {

using namespace test;  // NOLINT
using testing::ElementsAre;
using testing::IsEmpty;

DraftInner pocket_line(double x, double y) {
  return {"place",
          {edge("left", line({x, y}, {x, y - 0.15})), edge("foot", line({x, y - 0.15}, {x + 0.1, y - 0.15})),
           edge("right", line({x + 0.1, y - 0.15}, {x + 0.1, y}))},
          next_place()};
}

DraftPiece pocket() {
  return polygon("pocket", {{0, 0.15}, {0, 0}, {0.1, 0}, {0.1, 0.15}}, {"left", "foot", "right", "mouth"});
}

DraftSeam upon(const char* side) {
  return sew({std::string("pocket.") + side}, {std::string("front.place.") + side});
}

TEST(Lines, AreNumberedBehindTheOutlineAndTheHoles) {
  DraftPiece front = rectangle("front", 0.4, 0.5);
  front.holes = {{"eye", {edge("rim", circle({0.05, 0.05}, {0.07, 0.05}))}, next_place()}};
  front.lines = {pocket_line(0.15, 0.35)};
  const Piece piece = make(garment({front})).garment.pieces.at(0);
  ASSERT_EQ(piece.edge_count(), 8);
  EXPECT_EQ(piece.edge(5).name, "place.left");
  EXPECT_TRUE(piece.is_inside(5));
  EXPECT_FALSE(piece.is_inside(4));
  EXPECT_EQ(piece.next_edge(5), 6);
  EXPECT_EQ(piece.next_edge(7), -1);
}

TEST(Lines, AreMirroredWithTheirPiece) {
  DraftPiece front = folded(rectangle("front", 0.4, 0.5), "left");
  front.holes = {{"eye", {edge("rim", circle({0.05, 0.05}, {0.07, 0.05}))}, next_place()}};
  front.lines = {pocket_line(0.15, 0.35)};
  front.notches = {{"place.left", 0.05, next_place()}};
  const Made made = make(garment({front}));
  const Piece& piece = made.garment.pieces.at(0);
  ASSERT_EQ(piece.lines.size(), 2u);
  EXPECT_EQ(piece.lines[1].back().name, "place.left");
  EXPECT_NEAR(piece.lines[1].back().curve.end().x, -0.15, 1e-12);
  ASSERT_EQ(piece.notches.size(), 2u);
  for (const Notch& notch : piece.notches) {
    EXPECT_EQ(piece.edge(notch.edge).name, "place.left");
    EXPECT_NEAR(piece.edge(notch.edge).curve.at(notch.at).y, 0.3, 1e-12);
  }
}

TEST(Lines, AreMetAsThePiecesLieInTheDrawing) {
  for (const bool turned : {false, true}) {
    DraftPiece patch = pocket();
    if (turned) std::reverse(patch.outline.begin(), patch.outline.end());
    if (turned) {
      for (DraftEdge& e : patch.outline) e.curve = e.curve.reversed();
    }
    DraftPiece front = rectangle("front", 0.4, 0.5);
    front.lines = {pocket_line(0.15, 0.35)};
    const Made made = make(garment({front, patch}, {upon("left"), upon("foot"), upon("right")}));
    ASSERT_THAT(made.diagnostics, IsEmpty());
    for (const Seam& seam : made.garment.seams) {
      const auto start = [&](const Chain& chain) {
        const Curve& curve = made.garment.pieces[chain.front().edge.piece].edge(chain.front().edge.edge).curve;
        return chain.front().forward ? curve.start() : curve.end();
      };
      const Vec2 shift = start(seam.second) - start(seam.first);
      EXPECT_NEAR(shift.x, 0.15, 1e-12) << seam.name;
      EXPECT_NEAR(shift.y, 0.2, 1e-12) << seam.name;
    }
  }
}

TEST(Lines, AreMetByTheCopyOnTheirOwnSide) {
  DraftPiece front = paired(rectangle("front", 0.4, 0.5));
  front.lines = {pocket_line(0.15, 0.35)};
  DraftSeam centre = sew({"front.left"}, {"front.left"});
  const Made made = make(garment({front, paired(pocket())}, {centre, upon("left"), upon("foot"), upon("right")}));
  ASSERT_THAT(made.diagnostics, IsEmpty());
  for (const Seam& seam : made.garment.seams) {
    if (seam.name == "front.left to front.left.mirrored") continue;
    EXPECT_EQ(made.garment.pieces[seam.first.front().edge.piece].side,
              made.garment.pieces[seam.second.front().edge.piece].side)
        << seam.name;
  }
}

TEST(Lines, ThatStrayAreErrors) {
  DraftPiece front = rectangle("front", 0.4, 0.5);
  const auto codes_with = [&](DraftInner line) {
    DraftPiece piece = front;
    piece.lines = {std::move(line)};
    return codes(make(garment({piece})));
  };
  EXPECT_THAT(codes_with(pocket_line(0.15, 0.35)), IsEmpty());
  EXPECT_THAT(codes_with(pocket_line(0.35, 0.35)), ElementsAre("E0339"));  // over the edge
  EXPECT_THAT(codes_with(pocket_line(0.5, 0.35)), ElementsAre("E0339"));   // beside the piece
  for (const double end : {0.2, 0.3}) {  // along the edge, short of its middle or beyond
    EXPECT_THAT(codes_with({"along", {edge("a", line({0, 0.1}, {0, end}))}, next_place()}), ElementsAre("E0339"));
  }
  EXPECT_THAT(codes_with({"bow",
                          {edge("a", line({0.1, 0.1}, {0.3, 0.3})), edge("b", line({0.3, 0.3}, {0.3, 0.1})),
                           edge("c", line({0.3, 0.1}, {0.1, 0.3}))},
                          next_place()}),
              ElementsAre("E0339"));
  front.lines = {pocket_line(0.15, 0.35)};
  front.lines.push_back({"across", {edge("a", line({0.1, 0.3}, {0.3, 0.3}))}, next_place()});
  EXPECT_THAT(codes(make(garment({front}))), ElementsAre("E0339"));
}

TEST(Lines, BearNoDartsAndNoAllowances) {
  DraftPiece front = rectangle("front", 0.4, 0.5);
  front.lines = {pocket_line(0.15, 0.35)};
  front.darts = {dart("dart1", "place.left", 0.07, 0.02, 0.05)};
  EXPECT_THAT(codes(make(garment({front}))), ElementsAre("E0339"));
  front.darts.clear();
  front.allowances = {{"place.foot", 0.01, next_place()}};
  EXPECT_THAT(codes(make(garment({front}))), ElementsAre("E0339"));
}

TEST(Lines, MayEndOnAnEdgeButNotInAPleat) {
  DraftPiece front = rectangle("front", 0.4, 0.5);
  front.lines = {{"slit", {edge("a", line({0.2, 0}, {0.2, 0.1}))}, next_place()}};
  const Made made = make(garment({front}));
  EXPECT_THAT(codes(made), IsEmpty());
  EXPECT_EQ(made.garment.pieces.at(0).edges.size(), 5u);  // divided there
  DraftPleat pleat;
  pleat.name = "pleat1";
  pleat.place = {"bottom", 0.2};
  pleat.depth = 0.03;
  front.pleats = {pleat};
  EXPECT_THAT(codes(make(garment({front}))), ElementsAre("E0339"));
}

}  // namespace
}  // namespace toile
