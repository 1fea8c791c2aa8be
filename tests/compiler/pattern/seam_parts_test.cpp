// Parts of edges, layers, tied places, closures and the order of sewing.
#include "compiler/pattern/sewing_order.hpp"
#include "tests/compiler/pattern/drafting.hpp"

namespace toile::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

DraftSeam sew_parts(const std::string& first, DrawnSpan a, const std::string& second, DrawnSpan b) {
  DraftSeam seam = sew({first}, {second});
  seam.first[0].part = a;
  seam.second[0].part = b;
  return seam;
}

TEST(SeamParts, AnEdgeIsSewnInTwoParts) {
  const DraftPiece a = rectangle("a", 0.3, 0.4), b = rectangle("b", 0.3, 0.4), c = rectangle("c", 0.3, 0.4);
  const Made made = make(garment({a, b, c}, {sew_parts("a.right", {0, 0.15}, "b.left", {0.25, 0.4}),
                                             sew_parts("a.right", {0.15, 0.4}, "c.left", {0, 0.25})}));
  EXPECT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment), ElementsAre("a.right | -b.left#1", "a.right#1 | -c.left"));
  const Made twice = make(garment({a, b, c}, {sew_parts("a.right", {0, 0.2}, "b.left", {0.2, 0.4}),
                                              sew_parts("a.right", {0.15, 0.4}, "c.left", {0, 0.25})}));
  EXPECT_THAT(codes(twice), ElementsAre("E0317"));
}

TEST(SeamParts, StandInChains) {
  DraftSeam seam = sew({"band.bottom"}, {"a.top", "b.top"});
  seam.second[0].part = DrawnSpan{0, 0.2};
  const Made made = make(garment({rectangle("a", 0.3, 0.4), rectangle("b", 0.3, 0.4), rectangle("band", 0.5, 0.1)},
                                 {sew({"a.right"}, {"b.left"}), seam}));
  EXPECT_EQ(complaints(made), "");
}

TEST(SeamParts, AnEdgeSewnASecondTimeIsToldOnceWhateverItsLength) {
  const Made made = make(garment({rectangle("a", 0.3, 0.4), rectangle("b", 0.3, 0.4)},
                                 {sew({"a.right"}, {"b.left"}), sew({"a.right"}, {"b.bottom"})}));
  EXPECT_THAT(codes(made), ElementsAre("E0317"));
}

TEST(SeamParts, FurtherLayersAreSewnInTheSameSeam) {
  DraftSeam seam = sew({"a.right"}, {"b.left"});
  seam.layers = {refs({"flap.left"})};
  const Made made =
      make(garment({rectangle("a", 0.3, 0.4), rectangle("b", 0.3, 0.4), rectangle("flap", 0.1, 0.4)}, {seam}));
  EXPECT_EQ(complaints(made), "");
  ASSERT_EQ(made.garment.seams.size(), 2u);
  EXPECT_FALSE(made.garment.seams[0].is_layer);
  EXPECT_TRUE(made.garment.seams[1].is_layer);
}

TEST(SeamParts, TheFullnessIsTakenWhereItIsSaid) {
  DraftSeam seam = sew({"a.top"}, {"b.bottom"});
  seam.fullness = Seam::Fullness::Gather;
  seam.taken = {{0.1, false}, {0.5, true}};
  seam.notches = {{0.05, false}};
  const Made made = make(garment({rectangle("a", 0.6, 0.4), rectangle("b", 0.5, 0.4)}, {seam}));
  ASSERT_EQ(complaints(made), "");
  // `top` is drawn from its right end on, as it is walked with its cloth on the left.
  ASSERT_EQ(made.garment.seams[0].ties.size(), 3u);
  EXPECT_THAT(made.garment.seams[0].ties[0],
              ElementsAre(testing::DoubleNear(0.05, 1e-12), testing::DoubleNear(0.05, 1e-12)));
  EXPECT_THAT(made.garment.seams[0].ties[1],
              ElementsAre(testing::DoubleNear(0.1, 1e-12), testing::DoubleNear(0.1, 1e-12)));
  EXPECT_THAT(made.garment.seams[0].ties[2],
              ElementsAre(testing::DoubleNear(0.3, 1e-12), testing::DoubleNear(0.2, 1e-12)));
  EXPECT_EQ(made.garment.pieces[0].notches.size(), 1u);
  EXPECT_EQ(made.garment.pieces[1].notches.size(), 1u);
  seam.taken = {{0.1, false}, {0.15, false}};
  EXPECT_THAT(codes(make(garment({rectangle("a", 0.6, 0.4), rectangle("b", 0.5, 0.4)}, {seam}))), ElementsAre("E0334"));
}

TEST(SeamParts, OpenClosuresTieNothing) {
  DraftSeam seam = sew({"a.right"}, {"b.left"});
  seam.closure = Seam::Closure::Zipped;
  seam.open = true;
  const Made made = make(garment({rectangle("a", 0.3, 0.4), rectangle("b", 0.3, 0.4)}, {seam}));
  EXPECT_THAT(codes(made), ElementsAre("E0320"));
}

TEST(SewingOrder, ALineOverASeamIsSewnAfterIt) {
  DraftGarment draft = garment({rectangle("band", 0.6, 0.04), rectangle("a", 0.3, 0.4), rectangle("b", 0.3, 0.4)},
                               {sew({"band.bottom"}, {"a.top", "b.top"}), sew({"a.right"}, {"b.left"})});
  draft.pieces[1].darts = {dart("d", "bottom", 0.15, 0.02, 0.1)};
  const Made made = make(draft);
  ASSERT_EQ(complaints(made), "");
  std::vector<std::string> names;
  for (const SewingStep& step : sewing_order(made.garment)) names.push_back(made.garment.seams[step.seams[0]].name);
  EXPECT_THAT(names, ElementsAre("a.d", "a.right to b.left", "band.bottom to a.top + b.top"));
  draft.seams[0].step = 1;
  names.clear();
  const Made stated = make(draft);
  for (const SewingStep& step : sewing_order(stated.garment)) names.push_back(stated.garment.seams[step.seams[0]].name);
  EXPECT_THAT(names, ElementsAre("a.d", "band.bottom to a.top + b.top", "a.right to b.left"));
}

TEST(Twist, OfAWornGarmentIsFoundWithItsRemedy) {
  DraftGarment draft = garment({rectangle("a", 0.3, 0.4), rectangle("b", 0.3, 0.4)},
                               {sew({"a.left"}, {"b.right"}), sew({"a.right"}, {"b.left"}, true)});
  EXPECT_THAT(codes(make(draft)), ElementsAre("W0337"));  // a Möbius strip
  draft.wears = {wear({"a.top", "b.top"}, "waist")};
  EXPECT_THAT(codes(make(draft)), ElementsAre("E0335"));
  draft.seams = {sew({"a.left"}, {"b.left"}), sew({"a.right"}, {"b.right"})};
  const Made upside_down = make(draft);
  ASSERT_THAT(codes(upside_down), ElementsAre("E0319"));
  EXPECT_THAT(upside_down.diagnostics[0].help, testing::HasSubstr("sew `a.left` to `b.right`"));
}

}  // namespace
}  // namespace toile::test
