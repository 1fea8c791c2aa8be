// Pieces drawn on a body, from the chart to the redrawn pattern.
#include "runtime/develop/develop.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "runtime/develop/grain_study.hpp"
#include "runtime/develop/redraw.hpp"
#include "tests/support/flat_region.hpp"

namespace toile {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double outline_tolerance = 2e-4;  // [m]

/// Round, with a waist: no part of it is developable.
std::shared_ptr<const Body> torso() {
  BodySpec spec;
  spec.name = "torso";
  FormSpec form;
  for (const auto& [level, girth] : {std::pair(0.8, 0.94), {1.0, 0.68}, {1.2, 0.9}, {1.4, 0.6}}) {
    BodySection section;
    section.name = level == 1.0 ? "waist" : "";
    section.level = level;
    section.girth = girth;
    form.sections.push_back(section);
  }
  spec.shape = form;
  std::string error;
  auto body = Body::make(spec, &error);
  EXPECT_TRUE(body) << error;
  return body;
}

DraftPiece panel(const std::string& name, double left, double low, double right, double high) {
  DraftPiece piece;
  piece.name = name;
  piece.chart = ChartSpec{};
  const std::array<Vec2, 4> corners{Vec2{left, low}, Vec2{right, low}, Vec2{right, high}, Vec2{left, high}};
  const std::array<const char*, 4> names{"low", "right", "high", "left"};
  for (std::size_t i = 0; i < 4; ++i) piece.outline.push_back({names[i], line(corners[i], corners[(i + 1) % 4]), {}});
  return piece;
}

DraftDart slit(const std::string& edge, double at, double depth) {
  DraftDart dart;
  dart.name = "slit";
  dart.edge = edge;
  dart.at = at;
  dart.width = 0.002;
  dart.depth = depth;
  return dart;
}

FabricSheet cotton() {
  FabricSheet sheet;
  sheet.lt = WarpWeft{0.80, 0.72};
  sheet.emt = WarpWeft{0.03, 0.06};
  sheet.g = WarpWeft{50, 50};
  sheet.weight = 0.115;
  sheet.b = WarpWeft{6e-6, 4e-6};
  return sheet;
}

struct Made {
  Garment garment;
  SewnMesh mesh;
  Target target;
  Development development;
};

Made developed(const std::vector<DraftPiece>& pieces, const std::vector<DraftSeam>& seams = {}, double edge = 0.01) {
  DraftGarment draft;
  draft.name = "g";
  draft.pieces = pieces;
  draft.seams = seams;
  draft.fabric = cotton();
  std::vector<Diagnostic> found;
  Made made;
  made.garment = make_garment(draft, found);
  EXPECT_THAT(found, IsEmpty());
  PMeshOptions options;
  options.target_edge = edge;
  made.mesh = sew(made.garment, options);
  made.target = find_target(made.garment, made.mesh, *torso());
  if (made.target.troubles.empty()) made.development = develop(made.garment, made.mesh, made.target, {}, {});
  return made;
}

void expect_sound(const Made& made) {
  ASSERT_THAT(made.target.troubles, IsEmpty());
  EXPECT_TRUE(made.development.flat.converged) << made.development.flat.residual_relative;
  EXPECT_EQ(made.development.flat.flipped, 0);
  EXPECT_LT(made.development.flat.mismatch, 1e-4);
}

double edge_length(const Made& made, int piece, const std::string& name) {
  for (int e = 0; e < made.garment.pieces[static_cast<std::size_t>(piece)].edge_count(); ++e) {
    if (made.garment.pieces[static_cast<std::size_t>(piece)].edge(e).name != name) continue;
    const auto& points = made.mesh.p.edge_nodes[static_cast<std::size_t>(piece)][static_cast<std::size_t>(e)].points;
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      sum += distance(made.development.points[static_cast<std::size_t>(points[i - 1])],
                      made.development.points[static_cast<std::size_t>(points[i])]);
    }
    return sum;
  }
  ADD_FAILURE() << "no edge " << name;
  return 0;
}

DraftSeam seam(const std::string& first, const std::string& first_edge, const std::string& second,
               const std::string& second_edge) {
  DraftSeam made;
  made.first = {{first, first_edge, {}, {}}};
  made.second = {{second, second_edge, {}, {}}};
  return made;
}

TEST(Develop, OpensADartAndKeepsItsSidesEquallyLong) {
  DraftPiece front = panel("front", -0.1, 1.0, 0.1, 1.25);
  front.darts = {slit("low", 0.14, 0.14)};
  const Made made = developed({front});
  expect_sound(made);
  EXPECT_NEAR(edge_length(made, 0, "slit.left"), edge_length(made, 0, "slit.right"), 1e-4);
  const OpenedDart opened = opened_dart(made.mesh.p, 0, made.garment.pieces[0].darts[0], made.development);
  EXPECT_GT(opened.width, 0.005);
  EXPECT_LT(opened.width, 0.06);
}

TEST(Develop, ADartTakesAwayEnergy) {
  const Made whole = developed({panel("front", -0.1, 1.0, 0.1, 1.25)});
  DraftPiece front = panel("front", -0.1, 1.0, 0.1, 1.25);
  front.darts = {slit("low", 0.1, 0.16)};
  const Made cut = developed({front});
  const auto total = [](const Made& made) {
    const MembraneEnergy& energy = made.development.flat.energy;
    return energy.warp + energy.weft + energy.shear;
  };
  EXPECT_LT(total(cut), 0.6 * total(whole));
}

TEST(Develop, GivesPiecesThatShareASeamTheSameLength) {
  const Made made = developed({panel("front", -0.1, 0.95, 0.05, 1.2), panel("side", 0.05, 0.95, 0.2, 1.2)},
                              {seam("front", "right", "side", "left")});
  expect_sound(made);
  EXPECT_NEAR(edge_length(made, 0, "right"), edge_length(made, 1, "left"), 1e-4);
}

TEST(Develop, MakesTheFirstSideOfAnEasedSeamLonger) {
  DraftSeam eased = seam("front", "right", "side", "left");
  eased.fullness = Seam::Fullness::Ease;
  eased.stated = 0.012;
  const Made made = developed({panel("front", -0.1, 0.95, 0.05, 1.2), panel("side", 0.05, 0.95, 0.2, 1.2)}, {eased});
  expect_sound(made);
  EXPECT_NEAR(edge_length(made, 0, "right") - edge_length(made, 1, "left"), 0.012, 1e-4);
}

TEST(Develop, TurnsAFreeGrainWhereItCostsLeast) {
  const auto total = [](const Made& made) {
    const MembraneEnergy& energy = made.development.flat.energy;
    return energy.warp + energy.weft + energy.shear;
  };
  DraftPiece front = panel("front", -0.1, 1.0, 0.1, 1.25);
  double least = 1e300;
  for (const double angle : {-90.0, -60.0, -45.0, -30.0, 0.0}) {
    front.warp = direction(angle * std::numbers::pi / 180);
    least = std::min(least, total(developed({front})));
  }
  front.warp = {0, -1};
  front.free_grain = true;
  const Made free = developed({front});
  expect_sound(free);
  EXPECT_LE(total(free), least * (1 + 1e-6));
}

TEST(Develop, ClosesASeamAtTheBack) {
  const double half = 0.1 * std::numbers::pi;
  const Made made = developed({panel("tube", -half, 1.05, half, 1.15)}, {seam("tube", "right", "tube", "left")});
  expect_sound(made);
}

TEST(Develop, TellsOfARegionBeyondTheBody) {
  const Made made = developed({panel("front", -0.1, 1.2, 0.1, 1.6)});
  ASSERT_EQ(made.target.troubles.size(), 1u);
  EXPECT_THAT(made.target.troubles[0].message, HasSubstr("piece `front` at ("));
  EXPECT_THAT(made.target.troubles[0].message, HasSubstr("beyond the body"));
}

TEST(Develop, TellsOfSewnEdgesThatDoNotLieOnEachOther) {
  const Made made = developed({panel("front", -0.1, 0.95, 0.05, 1.2), panel("side", 0.07, 0.95, 0.2, 1.2)},
                              {seam("front", "right", "side", "left")});
  ASSERT_EQ(made.target.troubles.size(), 1u);
  EXPECT_THAT(made.target.troubles[0].message, HasSubstr("mm apart on the body"));
}

TEST(Redraw, IsAPatternLikeOneThatWasDrawn) {
  DraftPiece front = panel("front", 0, 1.0, 0.11, 1.25);
  front.fold = "left";
  front.darts = {slit("low", 0.06, 0.14)};
  front.notches = {{"right", 0.1, {}}};
  front.allowances = {{"", 0.01, {}}};
  DraftPiece side = panel("side", 0.11, 1.0, 0.2, 1.25);
  side.mirrored = true;
  side.quantity = 2;
  const Made made = developed({front, side}, {seam("front", "right", "side", "left")});
  expect_sound(made);
  const Redrawn redrawn = redraw(made.garment, made.mesh, made.development, outline_tolerance);
  EXPECT_LE(redrawn.error, outline_tolerance);
  std::vector<Diagnostic> found;
  const Garment pattern = make_garment(redrawn.draft, found);
  EXPECT_THAT(found, IsEmpty());
  EXPECT_EQ(redrawn.draft.pieces.size(), 2u);
  EXPECT_TRUE(redrawn.draft.pieces[0].fold);
  EXPECT_TRUE(redrawn.draft.pieces[1].mirrored);
  EXPECT_EQ(pattern.pieces.size(), 3u) << "the front and a side left and right";
  EXPECT_EQ(pattern.seams.size(), 4u) << "two darts and two sides";
}

TEST(Redraw, KeepsBothHalvesWhereTheyCameOutDifferent) {
  DraftPiece front = panel("front", 0, 1.0, 0.11, 1.25);
  front.fold = "left";
  front.warp = direction(-0.8);  // the other half has it the other way
  const Made made = developed({front});
  expect_sound(made);
  const Redrawn redrawn = redraw(made.garment, made.mesh, made.development, outline_tolerance);
  EXPECT_FALSE(redrawn.draft.pieces[0].fold);
  std::vector<Diagnostic> found;
  make_garment(redrawn.draft, found);
  EXPECT_THAT(found, IsEmpty());
}

TEST(GrainStudy, FindsEachPatternBestAtItsOwnGrain) {
  const Made made = developed({panel("front", 0, 1.02, 0.11, 1.25)});
  expect_sound(made);
  const GrainStudy study = study_grain(made.mesh, make_law(made.garment.fabric), made.development, {});
  const MembraneEnergy energy = made.development.flat.energy;
  EXPECT_NEAR(study.energy[0][0], energy.warp + energy.weft + energy.shear, 1e-9);
  for (std::size_t own = 0; own < 3; ++own) {
    for (std::size_t other = 0; other < 3; ++other) {
      if (own != other) {
        EXPECT_GT(study.energy[own][other], 1.001 * study.energy[own][own]) << own << " " << other;
      }
    }
  }
  EXPECT_EQ(study.apart[0], 0);
  EXPECT_GT(study.apart[1], 1e-4);
}

}  // namespace
}  // namespace toile
