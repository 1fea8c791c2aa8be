// Darts moved and trued, slashes opened, pleats folded.
#include <cmath>
#include <numeric>
#include <random>

#include "compiler/pattern/region.hpp"
#include "tests/compiler/pattern/drafting.hpp"

namespace toile::test {
namespace {

using testing::ElementsAre;

double cloth_area(const Piece& piece) {
  double area = signed_area(whole_outline(piece.edges));
  for (const auto& hole : piece.holes) area += signed_area(whole_outline(hole));
  return area;
}

double sewn_length(const Piece& piece, const std::string& name) {
  double sum = 0;
  for (const PieceEdge& edge : piece.edges) {
    if (edge.name == name && !edge.folded_under) sum += edge.curve.length();
  }
  return sum;
}

double cone_angle(const Piece& piece, const Dart& dart) {
  const Vec2 a = piece.edge(dart.left_leg).curve.start() - dart.tip;
  const Vec2 b = piece.edge(dart.right_leg).curve.end() - dart.tip;
  return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

DraftPivot pivot(std::string dart_name, double share, std::string edge_name, double at, std::string name) {
  return {std::move(dart_name), share, std::move(edge_name), at, std::move(name), next_place()};
}

Piece only_piece(const DraftPiece& draft) {
  const Made made = make(garment({draft}));
  EXPECT_EQ(complaints(made), "");
  return made.garment.pieces.empty() ? Piece{} : made.garment.pieces[0];
}

TEST(Pivot, KeepsTheConeAngleAndTheClothAndAllOtherEdges) {
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i) {
    const auto number = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() % 1000) / 1000;
    };
    DraftPiece draft = rectangle("p", 0.4, 0.5);
    draft.darts = {dart("d", "top", number(0.1, 0.3), number(0.01, 0.06), number(0.1, 0.3))};
    const Piece before = only_piece(draft);
    const char* edges[] = {"bottom", "right", "left"};
    const std::string target = edges[random() % 3];
    draft.pivots = {pivot("d", 1, target, number(0.05, 0.35), "d")};
    const Piece after = only_piece(draft);
    ASSERT_EQ(after.darts.size(), 1u);
    EXPECT_NEAR(cone_angle(after, after.darts[0]), cone_angle(before, before.darts[0]), 1e-12);
    EXPECT_NEAR(cloth_area(after), cloth_area(before), 1e-12);
    for (const char* edge : {"bottom", "right", "top", "left"}) {
      EXPECT_NEAR(sewn_length(after, edge), sewn_length(before, edge), 1e-12) << edge;
    }
    const Curve &left = after.edge(after.darts[0].left_leg).curve, &right = after.edge(after.darts[0].right_leg).curve;
    EXPECT_NEAR(left.length(), right.length(), 1e-12);
  }
}

TEST(Pivot, TakesHolesAndMarksAlongAndLeavesTheFoldWhereItIs) {
  DraftPiece draft = folded(rectangle("p", 0.4, 0.5), "left");
  draft.darts = {dart("d", "top", 0.2, 0.04, 0.2)};
  draft.holes = {{"eye", {edge("rim", circle({0.35, 0.45}, {0.36, 0.45}))}, next_place()}};
  draft.spots = {{PointMark::Kind::Drill, {0.35, 0.4}, 0, 0, next_place()}};
  draft.pivots = {pivot("d", 1, "right", 0.25, "d")};
  const Piece piece = only_piece(draft);
  ASSERT_TRUE(piece.fold);
  EXPECT_NEAR(piece.fold->from.x, 0, 1e-12);
  ASSERT_EQ(piece.spots.size(), 2u);
  EXPECT_GT(distance(piece.spots[0].at, {0.35, 0.4}), 0.01);
  const Vec2 rim = piece.holes[0][0].curve.at(0.01);
  EXPECT_NEAR(distance(rim, piece.spots[0].at), distance(circle({0.35, 0.45}, {0.36, 0.45}).at(0.01), {0.35, 0.4}),
              0.02);
}

TEST(Pivot, OfAShareLeavesTwoDartsThatEndBeforeTheirTip) {
  DraftPiece draft = rectangle("p", 0.4, 0.5);
  draft.darts = {dart("d", "top", 0.2, 0.05, 0.2)};
  draft.pivots = {pivot("d", 0.5, "right", 0.2, "side")};
  EXPECT_THAT(codes(make(garment({draft}))), ElementsAre("E0330"));
  draft.darts[0].short_of_tip = 0.02;
  const Piece piece = only_piece(draft);
  ASSERT_EQ(piece.darts.size(), 2u);
  EXPECT_GT(distance(piece.darts[0].tip, piece.darts[1].tip), 0.02);
}

TEST(TruedDart, RunsOnSmoothlyOnceItIsClosed) {
  DraftPiece draft = rectangle("p", 0.4, 0.5);
  draft.darts = {dart("d", "top", 0.2, 0.05, 0.15)};
  draft.darts[0].trued = true;
  draft.darts.push_back(dart("e", "right", 0.25, 0.04, 0));
  draft.darts[1].tip = Vec2{0.25, 0.18};  // aslant
  const Piece piece = only_piece(draft);
  for (const Dart& each : piece.darts) {
    const int n = static_cast<int>(piece.edges.size());
    const Curve& before = piece.edges[(each.left_leg + n - 1) % n].curve;
    const Curve& after = piece.edges[(each.right_leg + 1) % n].curve;
    EXPECT_NEAR(piece.edge(each.left_leg).curve.length(), piece.edge(each.right_leg).curve.length(), 1e-9);
    const Vec2 a = before.end() - each.tip, b = after.start() - each.tip;
    const Curve closed = after.rotated(std::atan2(cross(b, a), dot(b, a)), each.tip);
    EXPECT_NEAR(distance(closed.start(), before.end()), 0, 1e-9);
    EXPECT_NEAR(cross(before.tangent(before.length()), closed.tangent(0)), 0, 1e-6);
  }
}

TEST(DartInside, IsAHoleSewnToItselfOnBothHalves) {
  DraftPiece draft = folded(rectangle("p", 0.3, 0.5), "left");
  draft.darts = {dart("d", "", 0, 0.03, 0)};
  draft.darts[0].inside = {{0.15, 0.4}, {0.15, 0.1}};
  draft.darts[0].widest = 0.12;
  const Made made = make(garment({draft}));
  ASSERT_EQ(complaints(made), "");
  const Piece& piece = made.garment.pieces[0];
  ASSERT_EQ(piece.darts.size(), 2u);
  EXPECT_EQ(piece.holes.size(), 2u);
  ASSERT_EQ(made.garment.seams.size(), 2u);
  for (const Dart& each : piece.darts) {
    const Curve &left = piece.edge(each.left_leg).curve, &right = piece.edge(each.right_leg).curve;
    EXPECT_NEAR(left.length(), right.length(), 1e-12);
    EXPECT_NEAR(distance(left.end(), each.tip), 0, 1e-12);
    EXPECT_NEAR(distance(right.end(), *each.other_tip), 0, 1e-12);
  }
  draft.darts[0].inside.to = {0.35, 0.1};
  EXPECT_THAT(codes(make(garment({draft}))), ElementsAre("E0311"));
}

TEST(Dart, IsCutIntoAHolesEdge) {
  DraftPiece draft = rectangle("p", 0.5, 0.5);
  draft.holes = {{"eye", {edge("rim", circle({0.25, 0.25}, {0.35, 0.25}))}, next_place()}};
  draft.darts = {dart("d", "eye.rim", 0.15, 0.02, 0.06)};
  draft.notches = {{"eye.rim", 0.4, next_place()}};
  const Piece piece = only_piece(draft);
  ASSERT_EQ(piece.darts.size(), 1u);
  EXPECT_GT(distance(piece.darts[0].tip, {0.25, 0.25}), 0.14);
  EXPECT_EQ(piece.edge(piece.notches[0].edge).name, "eye.rim");
}

DraftSpread spread(const std::string& from, double a, double by, const std::string& to, double b, double other_by) {
  return {{from, a}, {to, b}, by, other_by, next_place()};
}

TEST(Spread, OpensOneEdgeAndKeepsTheOther) {
  std::mt19937 random(3);
  for (int i = 0; i < 30; ++i) {
    const auto number = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() % 1000) / 1000;
    };
    DraftPiece draft = rectangle("p", 0.4, 0.5);
    if (i % 2 == 1) draft = folded(std::move(draft), "left");
    const double by = number(0.01, 0.06);
    const int count = 1 + static_cast<int>(random() % 3);
    for (int k = 0; k < count; ++k) {
      draft.spreads.push_back(spread("bottom", 0.1 + 0.1 * k, by, "top", 0.32 - 0.1 * k, 0));
    }
    const Piece piece = only_piece(draft);
    const double copies = i % 2 == 1 ? 2 : 1;
    EXPECT_NEAR(sewn_length(piece, "bottom"), copies * (0.4 + count * by), 1e-8);
    EXPECT_NEAR(sewn_length(piece, "top"), copies * 0.4, 1e-8);
    EXPECT_NEAR(sewn_length(piece, "right"), copies * 0.5, 1e-12);
    EXPECT_GT(cloth_area(piece), copies * 0.2);
  }
}

TEST(Spread, OpensBothEdgesAlikeByAStrip) {
  DraftPiece draft = rectangle("p", 0.4, 0.5);
  draft.spreads = {spread("bottom", 0.2, 0.05, "top", 0.2, 0.05)};
  draft.notches = {{"bottom", 0.3, next_place()}};
  const Piece piece = only_piece(draft);
  EXPECT_NEAR(cloth_area(piece), 0.45 * 0.5, 1e-12);
  EXPECT_NEAR(piece.notches[0].at, 0.35, 1e-12);
}

DraftPleat pleat(const std::string& edge_name, double at, double depth, PleatStyle style = PleatStyle::Knife) {
  DraftPleat made;
  made.name = "pleat";
  made.place = {edge_name, at};
  made.depth = depth;
  made.style = style;
  made.written = next_place();
  return made;
}

TEST(Pleat, TakesTwiceItsDepthOutOfTheSewnLine) {
  DraftPiece draft = rectangle("p", 0.4, 0.5);
  draft.pleats = {pleat("top", 0.1, 0.02), pleat("top", 0.28, 0.015, PleatStyle::Inverted)};
  const Made made = make(garment({draft}));
  ASSERT_EQ(complaints(made), "");
  const Piece& piece = made.garment.pieces[0];
  EXPECT_NEAR(sewn_length(piece, "top"), 0.4 - 2 * 0.02 - 4 * 0.015, 1e-12);
  ASSERT_EQ(piece.pleats.size(), 3u);
  EXPECT_EQ(made.garment.seams.size(), 6u);
  for (const Pleat& each : piece.pleats) {
    const double depth = piece.edge(each.face).curve.length();
    EXPECT_NEAR(piece.edge(each.under).curve.length(), depth, 1e-12);
    EXPECT_NEAR(piece.edge(each.back).curve.length(), depth, 1e-12);
  }
}

TEST(Pleat, IsSewnToABandOfItsFoldedLength) {
  DraftPiece skirt = rectangle("skirt", 0.4, 0.5);
  skirt.pleats = {pleat("top", 0.2, 0.03)};
  const DraftPiece band = rectangle("band", 0.34, 0.04);
  const Made made = make(garment({skirt, band}, {sew({"skirt.top"}, {"band.bottom"})}));
  EXPECT_EQ(complaints(made), "");
  skirt.pleats.push_back(pleat("top", 0.22, 0.03));
  EXPECT_THAT(codes(make(garment({skirt}))), ElementsAre("E0333"));
}

TEST(Pleat, OnAFoldedPieceIsFoldedOnBothHalves) {
  DraftPiece draft = folded(rectangle("p", 0.4, 0.5), "left");
  draft.pleats = {pleat("top", 0.2, 0.02)};
  const Piece piece = only_piece(draft);
  ASSERT_EQ(piece.pleats.size(), 2u);
  for (const Pleat& each : piece.pleats) {
    EXPECT_EQ(std::abs(each.face - each.under), 1);
    EXPECT_EQ(each.back - each.under, each.under - each.face);
  }
}

}  // namespace
}  // namespace toile::test
