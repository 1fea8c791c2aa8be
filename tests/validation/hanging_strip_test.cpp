// A strip hung by its upper edge: the tension at a distance s from its lower end is w s, and the elongation follows the
// cloth's curve.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/drape/drape.hpp"
#include "runtime/energy/gravity.hpp"
#include "runtime/fabric/law.hpp"
#include "tests/support/sheet.hpp"

namespace toile {
namespace {

/// The strain at which a law carries a force per width, by bisection.
double strain_under(const ElongationLaw& law, double force) {
  double low = 0, high = 1;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (law(middle).force < force ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double elongation_error(int divisions) {
  constexpr double length = 0.5, width = 0.05;
  test::Sheet strip = test::rectangle(length, width, divisions, std::max(divisions / 10, 1), 0);
  FabricSheet fabric;
  fabric.weight = 4.0;  // heavy, so that the curve is felt: 20 N/m at the top
  fabric.emt = WarpWeft{0.3, 0.3};
  fabric.lt = WarpWeft{0.6, 0.6};
  fabric.b = WarpWeft{1e-5, 1e-5};
  Placed start;
  for (std::size_t v = 0; v < strip.points.size(); ++v) {
    start.positions.push_back({strip.points[v].y, 0, -strip.points[v].x});
    if (strip.points[v].x == 0) start.held.push_back(static_cast<int>(v));
  }
  const Drape drape = toile::drape(strip.cloth, fabric, nullptr, start, {.accuracy = 1e-8}, {});
  EXPECT_TRUE(drape.converged) << drape.trouble;
  const ElongationLaw law = ElongationLaw::from_kes(0.3, 0.6);
  double expected = 0;
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    expected += strain_under(law, 4.0 * standard_gravity * length * (i + 0.5) / steps) * length / steps;
  }
  double lowest = 0;
  for (const Vec3& p : drape.positions) lowest = std::min(lowest, p.z);
  return std::abs(-lowest - length - expected) / expected;
}

TEST(HangingStrip, ElongatesAsTheCurveOfTheClothSays) {
  const double coarse = elongation_error(20), fine = elongation_error(40);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(fine, 0.5 * coarse);
}

}  // namespace
}  // namespace toile
