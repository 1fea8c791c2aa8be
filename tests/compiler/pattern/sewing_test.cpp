// Which edges a `sew` or `wear` of the script means: copies, order, direction.
#include <numbers>

#include "tests/compiler/pattern/drafting.hpp"

namespace toile {
namespace {

using namespace toile::test;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

using std::numbers::pi;

TEST(Sew, SingleEdgesMeetEndToStart) {
  const Made made = make(garment({rectangle("a", 0.3, 0.5), rectangle("b", 0.2, 0.5)}, {sew({"a.right"}, {"b.left"})}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment), ElementsAre("a.right | -b.left"));
}

TEST(Sew, ReversedMeetsStartToStart) {
  const Made made = make(garment({rectangle("strip", 1, 0.1)}, {sew({"strip.left"}, {"strip.right"}, true)}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment), ElementsAre("strip.left | strip.right"));
}

TEST(Sew, SideSeamsOfFoldedPanelsMeetTheMirrorImage) {
  const Made made = make(flared_skirt());
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment),
              ElementsAre("front.side | -back.side.mirrored", "front.side.mirrored | -back.side"));
  EXPECT_EQ(made.garment.seams.size(), 6u);  // and the four darts
  EXPECT_EQ(made.garment.seams[4].name, "front.side to back.side.mirrored");
}

TEST(Sew, ShouldersMeetTheMirrorImage) {
  const auto bodice = [](const char* name, double neck) {
    return folded(polygon(name, {{0, 0}, {0.25, 0}, {0.25, 0.25}, {0.2, 0.42}, {0.08, 0.45}, {0, neck}},
                          {"waist", "side", "armhole", "shoulder", "neck", "centre"}),
                  "centre");
  };
  const Made made = make(garment({bodice("front", 0.36), bodice("back", 0.42)},
                                 {sew({"front.shoulder"}, {"back.shoulder"}), sew({"front.side"}, {"back.side"})},
                                 {wear({"front.neck", "back.neck"}, "neck")}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment),
              ElementsAre("front.shoulder | -back.shoulder.mirrored", "front.shoulder.mirrored | -back.shoulder",
                          "front.side | -back.side.mirrored", "front.side.mirrored | -back.side"));
  EXPECT_EQ(described(made.garment, made.garment.wears[0].chain),
            "front.neck front.neck.mirrored back.neck back.neck.mirrored");
}

TEST(Sew, BodiceToSkirtMeetsTheSameSide) {
  const Made made =
      make(garment({folded(rectangle("bodice", 0.2, 0.4), "left"), folded(rectangle("skirt", 0.2, 0.6), "left")},
                   {sew({"bodice.bottom"}, {"skirt.top"})}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment),
              ElementsAre("bodice.bottom | -skirt.top", "bodice.bottom.mirrored | -skirt.top.mirrored"));
}

TEST(Sew, CentreBackOfAPairIsOneSeam) {
  const Made made = make(garment({paired(rectangle("back", 0.2, 0.6))}, {sew({"back.left"}, {"back.left"})}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment), ElementsAre("back.left | -back.left.mirrored"));
}

TEST(Sew, SideNamedInTheScriptIsThatOneAlone) {
  const Made made =
      make(garment({folded(rectangle("front", 0.2, 0.6), "left"), folded(rectangle("back", 0.2, 0.6), "left")},
                   {sew({"front.right.mirrored"}, {"back.right"})}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment), ElementsAre("front.right.mirrored | -back.right"));
}

TEST(Sew, BandTakesBothHalvesOfAFoldedEdge) {
  const Made made = make(garment({folded(rectangle("skirt", 0.2, 0.6), "left"), rectangle("band", 0.4, 0.04)},
                                 {sew({"band.bottom"}, {"skirt.top"})}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment), ElementsAre("band.bottom | -skirt.top.mirrored -skirt.top"));
}

TEST(Sew, BandAroundAWholeSkirtFollowsTheSideSeams) {
  const Made made = make(garment({folded(rectangle("front", 0.2, 0.6), "left"),
                                  folded(rectangle("back", 0.2, 0.6), "left"), rectangle("band", 0.8, 0.04)},
                                 {sew({"front.top", "back.top"}, {"band.bottom"}), sew({"front.right"}, {"back.right"}),
                                  sew({"band.left"}, {"band.right"})},
                                 {wear({"band.top"}, "waist")}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_EQ(described_seams(made.garment)[0], "front.top front.top.mirrored back.top back.top.mirrored | -band.bottom");
}

TEST(Sew, ChainOfFoldedPiecesPicksTheHalvesThatRunOn) {
  // Half a waist is the front's drawn half and the back's mirrored one; a folded band takes it.
  const Made made =
      make(garment({folded(rectangle("front", 0.2, 0.6), "left"), folded(rectangle("back", 0.2, 0.6), "left"),
                    folded(rectangle("band", 0.4, 0.04), "left")},
                   {sew({"front.right"}, {"back.right"}), sew({"front.top", "back.top"}, {"band.bottom"})}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_EQ(described_seams(made.garment)[2], "back.top.mirrored front.top | -band.bottom");
  EXPECT_EQ(described_seams(made.garment)[3], "front.top.mirrored back.top | -band.bottom.mirrored");
}

TEST(Sew, ArmholeMeetsTheCapFrontToFront) {
  const auto bodice = [](const char* name) {
    return paired(polygon(name, {{0, 0}, {0.25, 0}, {0.25, 0.25}, {0.2, 0.42}, {0, 0.45}},
                          {"waist", "side", "armhole", "shoulder", "centre"}));
  };
  const double armhole = std::hypot(0.05, 0.17), half = 0.15, rise = std::sqrt(armhole * armhole - half * half);
  const DraftPiece sleeve =
      paired(polygon("sleeve", {{-half, 0}, {half, 0}, {half, 0.4}, {0, 0.4 + rise}, {-half, 0.4}},
                     {"wrist", "front_seam", "front_cap", "back_cap", "back_seam"}));
  const Made made =
      make(garment({bodice("front"), bodice("back"), sleeve},
                   {sew({"front.side"}, {"back.side"}), sew({"front.shoulder"}, {"back.shoulder"}),
                    sew({"front.centre"}, {"front.centre"}), sew({"sleeve.front_seam"}, {"sleeve.back_seam"}),
                    sew({"front.armhole", "back.armhole"}, {"sleeve.front_cap", "sleeve.back_cap"})}));
  ASSERT_EQ(complaints(made), "");
  const std::vector<std::string> seams = described_seams(made.garment);
  EXPECT_EQ(seams[seams.size() - 4], "sleeve.front_seam | -sleeve.back_seam");
  EXPECT_EQ(seams[seams.size() - 2],
            "front.armhole back.armhole.mirrored | -sleeve.front_cap.mirrored -sleeve.back_cap.mirrored");
}

TEST(Sew, DartedEdgeMeansAllItsParts) {
  DraftPiece skirt = rectangle("skirt", 0.43, 0.6);
  skirt.darts = {dart("d", "top", 0.2, 0.03, 0.1)};
  const Made made = make(garment({skirt, rectangle("band", 0.4, 0.04)}, {sew({"band.bottom"}, {"skirt.top"})}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment), ElementsAre("band.bottom | -skirt.top#1 -skirt.top"));
}

TEST(Sew, EdgeClosedLikeAPurse) {
  const Made made = make(garment({rectangle("p", 0.3, 0.3)}, {sew({"p.top"}, {"p.top"})}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_THAT(described_seams(made.garment), ElementsAre("p.top | -p.top"));
}

TEST(Sew, TorusKleinBottleAndProjectivePlane) {
  for (const auto& [first, second] : {std::pair{false, false}, {false, true}, {true, true}}) {
    const Made made = make(
        garment({rectangle("p", 1, 0.5)}, {sew({"p.left"}, {"p.right"}, first), sew({"p.bottom"}, {"p.top"}, second)}));
    EXPECT_EQ(complaints(made), "");
    EXPECT_EQ(made.garment.seams.size(), 2u);
  }
}

TEST(Ease, EitherMayBeTheLonger) {
  for (const double longer : {0.5, 0.516}) {
    DraftSeam seam = sew({"a.right"}, {"b.left"});
    seam.fullness = Seam::Fullness::Ease;
    seam.stated = 0.008;
    const auto with = [&](double other) {
      return codes(make(garment({rectangle("a", 0.3, longer), rectangle("b", 0.3, other)}, {seam})));
    };
    EXPECT_THAT(with(0.508), ElementsAre());
    EXPECT_THAT(with(longer == 0.5 ? 0.512 : 0.504), ElementsAre("E0316"));
  }
}

TEST(Ease, WithoutAnAmountCoversATenthAndGatherAnything) {
  const auto with = [](Seam::Fullness fullness, double other) {
    DraftSeam seam = sew({"a.right"}, {"b.left"});
    seam.fullness = fullness;
    return codes(make(garment({rectangle("a", 0.3, 0.5), rectangle("b", 0.3, other)}, {seam})));
  };
  EXPECT_THAT(with(Seam::Fullness::Ease, 0.54), ElementsAre());
  EXPECT_THAT(with(Seam::Fullness::Ease, 0.6), ElementsAre("E0316"));
  EXPECT_THAT(with(Seam::Fullness::Stretch, 0.46), ElementsAre());
  EXPECT_THAT(with(Seam::Fullness::Gather, 1.5), ElementsAre());
  EXPECT_THAT(with(Seam::Fullness::None, 0.5004), ElementsAre());
  EXPECT_THAT(with(Seam::Fullness::None, 0.501), ElementsAre("E0316"));
}

TEST(Wear, RunsRoundTheSkirtInTheOrderOfTheScript) {
  const Made made = make(flared_skirt());
  ASSERT_EQ(complaints(made), "");
  EXPECT_EQ(described(made.garment, made.garment.wears[0].chain),
            "front.waist#1 front.waist front.waist.mirrored front.waist#1.mirrored "
            "back.waist#1 back.waist back.waist.mirrored back.waist#1.mirrored");
}

TEST(Wear, OpenJacketStartsAndEndsAtItsOpening) {
  const auto bodice = [](const char* name) {
    return polygon(name, {{0, 0}, {0.25, 0}, {0.25, 0.4}, {0.1, 0.45}, {0, 0.4}},
                   {"waist", "side", "shoulder", "neck", "centre"});
  };
  const Made made =
      make(garment({paired(bodice("front")), folded(bodice("back"), "centre")},
                   {sew({"front.shoulder"}, {"back.shoulder"})}, {wear({"front.neck", "back.neck"}, "neck")}));
  ASSERT_EQ(complaints(made), "");
  const std::string found = described(made.garment, made.garment.wears[0].chain);
  EXPECT_EQ(found, "front.neck.mirrored back.neck back.neck.mirrored front.neck");
}

TEST(Wear, WholeCircle) {
  DraftPiece disc;
  disc.name = "disc";
  disc.outline = {edge("rim", circle({0, 0}, {0.15, 0}))};
  const Made made = make(garment({disc}, {}, {wear({"disc.rim"}, "waist")}));
  ASSERT_EQ(complaints(made), "");
  EXPECT_NEAR(made.garment.pieces[0].edges[0].curve.length(), 0.3 * pi, 1e-12);
  EXPECT_EQ(described(made.garment, made.garment.wears[0].chain), "disc.rim");
}

}  // namespace
}  // namespace toile
