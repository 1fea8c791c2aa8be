// The heavy elastica: a strip clamped level droops under its weight. Tip positions (x, y)/L for G = w L^3 / B
// integrated to 1e-10 (docs/mechanics.md). Two strips hang from the middle of one, so that symmetry clamps both.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/drape/drape.hpp"
#include "runtime/energy/gravity.hpp"
#include "tests/support/sheet.hpp"

namespace toile {
namespace {

struct Tip {
  double gamma, x, y;
};

class HeavyElastica : public testing::TestWithParam<Tip> {};

TEST_P(HeavyElastica, TipIsWhereTheClosedFormHasIt) {
  constexpr double length = 0.1, width = 0.0125, rigidity = 1e-5;
  constexpr int columns = 40, rows = 5;
  const Tip tip = GetParam();
  test::Sheet strip = test::rectangle(2 * length, width, 2 * columns, rows);
  FabricSheet fabric;
  fabric.weight = tip.gamma * rigidity / (length * length * length) / standard_gravity;
  fabric.b = WarpWeft{rigidity, rigidity};
  fabric.stretch = WarpWeft{500, 500};
  fabric.shear = 200;
  Placed start;
  for (std::size_t v = 0; v < strip.points.size(); ++v) {
    start.positions.push_back({strip.points[v].x - length, strip.points[v].y, 0});
    if (std::abs(strip.points[v].x - length) < 1e-9) start.held.push_back(static_cast<int>(v));
  }
  const Drape drape = toile::drape(strip.cloth, fabric, nullptr, start, {.accuracy = 1e-6}, {});
  ASSERT_TRUE(drape.converged) << drape.trouble;
  double x = 0, y = 0;
  int ends = 0;
  for (std::size_t v = 0; v < strip.points.size(); ++v) {
    if (strip.points[v].x > 1e-9 && strip.points[v].x < 2 * length - 1e-9) continue;
    x += std::abs(drape.positions[v].x);
    y -= drape.positions[v].z;
    ++ends;
  }
  EXPECT_NEAR(x / ends / length, tip.x, 0.002);
  EXPECT_NEAR(y / ends / length, tip.y, 0.002);
  EXPECT_LT(drape.contact.weight_error, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Gamma, HeavyElastica,
                         testing::Values(Tip{1, 0.991246, 0.123471}, Tip{5, 0.846657, 0.495905},
                                         Tip{20, 0.445232, 0.829881}));

}  // namespace
}  // namespace toile
