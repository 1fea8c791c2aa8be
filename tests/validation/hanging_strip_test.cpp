// A strip hung by its upper edge: the tension at a distance s from its lower end is w s, and the elongation follows the
// cloth's curve.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <thread>

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

Drape hung_by_an_edge(const test::Sheet& sheet, double accuracy) {
  FabricSheet fabric;
  fabric.weight = 4.0;  // heavy, so that the curve is felt: 20 N/m at the top of half a metre
  fabric.emt = WarpWeft{0.3, 0.3};
  fabric.lt = WarpWeft{0.6, 0.6};
  fabric.b = WarpWeft{1e-5, 1e-5};
  Placed start;
  for (std::size_t v = 0; v < sheet.points.size(); ++v) {
    start.positions.push_back({sheet.points[v].y, 0, -sheet.points[v].x});
    if (sheet.points[v].x == 0) start.held.push_back(static_cast<int>(v));
  }
  return drape(sheet.cloth, fabric, nullptr, start, {.accuracy = accuracy}, {});
}

double elongation_error(int divisions) {
  constexpr double length = 0.5, width = 0.05;
  const test::Sheet strip = test::rectangle(length, width, divisions, std::max(divisions / 10, 1), 0);
  const Drape drape = hung_by_an_edge(strip, 1e-8);
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

TEST(HangingSheets, TwoAtOnceHangAsOneAlone) {
  const test::Sheet sheet = test::rectangle(0.4, 0.4, 24, 24, 0.3);
  const Drape alone = hung_by_an_edge(sheet, 1e-6);
  std::array<Drape, 2> both;
  {
    std::jthread first([&] { both[0] = hung_by_an_edge(sheet, 1e-6); });
    std::jthread second([&] { both[1] = hung_by_an_edge(sheet, 1e-6); });
  }
  for (const Drape& drape : both) {
    EXPECT_EQ(drape.iterations, alone.iterations);
    for (std::size_t v = 0; v < alone.positions.size(); ++v) {
      ASSERT_EQ(drape.positions[v].z, alone.positions[v].z) << "at vertex " << v;
    }
  }
}

}  // namespace
}  // namespace toile
