// Darts proposed for a cap of a sphere, which no single piece of cloth takes without strain.
#include "runtime/develop/darts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace toile {
namespace {

std::shared_ptr<const Body> ball(double radius) {
  BodySpec spec;
  spec.name = "ball";
  SphereSpec sphere;
  sphere.radius = radius;
  sphere.height = 1;
  spec.shape = sphere;
  std::string error;
  auto body = Body::make(spec, &error);
  EXPECT_TRUE(body) << error;
  return body;
}

/// Seen from above, of that radius along the sphere.
DraftGarment cap(double sphere, double radius) {
  DraftPiece piece;
  piece.name = "cap";
  ChartSpec chart;
  chart.map = ChartSpec::Map::Dome;
  chart.radius = sphere;
  piece.chart = chart;
  const Curve rim = circle({0, 0}, {radius, 0});
  piece.outline = {{"first", rim.part(0, rim.length() / 2), {}},
                   {"second", rim.part(rim.length() / 2, rim.length()), {}}};
  DraftGarment garment;
  garment.name = "g";
  garment.drawn_on = "ball";
  garment.pieces = {piece};
  garment.fabric.stretch = WarpWeft{2000, 2000};
  garment.fabric.shear = 1000;
  garment.fabric.weight = 0.1;
  return garment;
}

TEST(Darts, AreNotProposedWhereThereIsLittleStrain) {
  const auto body = ball(0.12);
  const DartProposal proposal = propose_darts(cap(0.12, 0.03), *body, 0.05, 300, {});
  EXPECT_TRUE(proposal.darts.empty());
  EXPECT_EQ(proposal.developments, 1);
}

TEST(Darts, TakeTheStrainOutOfACapAndEachDoesMuch) {
  const auto body = ball(0.12);
  const DraftGarment whole = cap(0.12, 0.1);
  const DartProposal proposal = propose_darts(whole, *body, 0.06, 400, {});
  ASSERT_FALSE(proposal.darts.empty());
  EXPECT_LE(proposal.darts.size(), 3U);
  EXPECT_EQ(proposal.draft.pieces[0].darts.size(), proposal.darts.size());
  // With them no more are needed.
  const DartProposal again = propose_darts(proposal.draft, *body, 0.06, 400, {});
  EXPECT_TRUE(again.darts.empty());
  for (const ProposedDart& dart : proposal.darts) {
    EXPECT_GT(dart.without.p95, 0.06);
    EXPECT_LT(norm(*dart.dart.tip), 0.065);  // none is short: strain is taken from all around
  }
}

TEST(Darts, ThatAreDrawnSayWhatTheyGain) {
  const auto body = ball(0.12);
  DraftGarment draft = cap(0.12, 0.1);
  DraftDart dart;
  dart.name = "cut";
  dart.edge = "first";
  dart.at = 0.1;
  dart.tip = Vec2{-0.01, 0.03};
  dart.depth = distance(draft.pieces[0].outline[0].curve.at(dart.at), *dart.tip);
  dart.width = slit_width(dart.depth);
  draft.pieces[0].darts = {dart};
  const std::vector<ProposedDart> gains = without_each_dart(draft, *body, 400, {});
  ASSERT_EQ(gains.size(), 1U);
  EXPECT_EQ(gains[0].dart.name, "cut");
  EXPECT_GT(gains[0].with.energy, 0);
  EXPECT_GT(gains[0].without.energy, 1.2 * gains[0].with.energy);
}

TEST(Darts, AreNotProposedForASaddle) {
  BodySpec spec;
  spec.name = "torso";
  FormSpec form;
  for (const auto& [level, girth] : {std::pair(0.8, 0.94), {1.0, 0.6}, {1.2, 0.94}}) {
    BodySection section;
    section.level = level;
    section.girth = girth;
    form.sections.push_back(section);
  }
  spec.shape = form;
  std::string error;
  const auto body = Body::make(spec, &error);
  ASSERT_TRUE(body) << error;
  DraftGarment draft = cap(0.1, 0.06);
  draft.pieces[0].chart = ChartSpec{};
  for (DraftEdge& edge : draft.pieces[0].outline) edge.curve = edge.curve.moved({0, 1});
  EXPECT_TRUE(propose_darts(draft, *body, 1e-4, 300, {}).darts.empty());
}

}  // namespace
}  // namespace toile
