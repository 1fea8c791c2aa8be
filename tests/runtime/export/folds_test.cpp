#include "runtime/report/folds.hpp"

#include <gtest/gtest.h>

#include "tests/runtime/export/draped_tube.hpp"

namespace toile {
namespace {

/// A closed line about a point off the origin, its radius given by its angle.
template <class Radius>
std::vector<Vec3> line_of(Radius radius, int points = 300) {
  std::vector<Vec3> loop;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    loop.push_back({3 + radius(angle) * std::cos(angle), -1 + radius(angle) * std::sin(angle), 0.5});
  }
  return loop;
}

TEST(Folds, AreCountedOnWaves) {
  for (const int folds : {3, 4, 5, 7, 12, 20}) {
    EXPECT_EQ(count_folds(line_of([&](double angle) { return 0.3 * (1 + 0.08 * std::cos(folds * angle)); })), folds);
  }
}

TEST(Folds, OfDifferentDepthAndWidthAllCount) {
  EXPECT_EQ(count_folds(line_of([](double angle) {
              return 0.3 * (1 + (0.1 + 0.05 * std::cos(angle)) * std::cos(5 * angle + 0.6 * std::sin(angle)));
            })),
            5);
}

TEST(Folds, StandOutFromAnOvalToo) {
  EXPECT_EQ(count_folds(line_of(
                [](double angle) { return 0.3 * (1 + 0.15 * std::cos(2 * angle) + 0.08 * std::cos(9 * angle)); })),
            9);
}

TEST(Folds, ACircleAnOvalAndAShallowWaveHaveNone) {
  EXPECT_EQ(count_folds(line_of([](double) { return 0.3; })), 0);
  EXPECT_EQ(count_folds(line_of([](double angle) { return 0.3 * (1 + 0.2 * std::cos(2 * angle)); })), 0);
  EXPECT_EQ(count_folds(line_of([](double angle) { return 0.3 * (1 + 0.02 * std::cos(6 * angle)); })), 0);
}

TEST(Folds, RipplesOnAFoldDoNotSplitIt) {
  EXPECT_EQ(count_folds(line_of(
                [](double angle) { return 0.3 * (1 + 0.15 * std::cos(4 * angle) + 0.004 * std::sin(29 * angle)); })),
            4);
}

TEST(Folds, DoNotDependOnWhereTheLineStartsOrWhichWayItRuns) {
  std::vector<Vec3> loop = line_of([](double angle) { return 0.3 * (1 + 0.1 * std::cos(6 * angle)); }, 97);
  std::rotate(loop.begin(), loop.begin() + 31, loop.end());
  EXPECT_EQ(count_folds(loop), 6);
  std::reverse(loop.begin(), loop.end());
  EXPECT_EQ(count_folds(loop), 6);
}

TEST(Folds, OfNothingAreNone) {
  EXPECT_EQ(count_folds({}), 0);
  EXPECT_EQ(count_folds({{1, 2, 3}}), 0);
  EXPECT_EQ(count_folds({{1, 2, 3}, {1, 2, 3}}), 0);
}

TEST(BoundaryLoops, OfATubeAreItsTwoRims) {
  const DrapedTube tube = draped_tube();
  const auto loops = boundary_loops(tube.mesh.s);
  ASSERT_EQ(loops.size(), 2U);
  for (const auto& loop : loops) EXPECT_EQ(loop.size(), 2U * kColumns);
}

TEST(BoundaryLoops, TheLowestFreeOneIsTheHem) {
  const DrapedTube tube = draped_tube();
  const std::vector<bool> none(tube.drape.positions.size(), false);
  const auto hem = lowest_free_loop(tube.mesh.s, tube.drape.positions, none);
  ASSERT_TRUE(hem.has_value());
  for (const int vertex : *hem) EXPECT_NEAR(tube.drape.positions[static_cast<std::size_t>(vertex)].z, -0.2, 1e-12);
  const std::vector<bool> all(tube.drape.positions.size(), true);
  EXPECT_FALSE(lowest_free_loop(tube.mesh.s, tube.drape.positions, all).has_value());
}

}  // namespace
}  // namespace toile
