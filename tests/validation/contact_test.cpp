// Contact carries the weight, its pressure is k d, and friction holds up to its angle.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "runtime/drape/drape.hpp"
#include "runtime/energy/gravity.hpp"
#include "tests/support/incline.hpp"
#include "tests/support/sheet.hpp"

namespace toile {
namespace {

FabricSheet cotton() {
  FabricSheet fabric;
  fabric.weight = 0.12;
  fabric.emt = WarpWeft{0.03, 0.08};
  fabric.b = WarpWeft{6e-6, 4e-6};
  fabric.hb = WarpWeft{4e-4, 3e-4};
  return fabric;
}

struct OnIncline {
  test::Sheet sheet = test::rectangle(0.2, 0.15, 10, 8);
  Placed start;
  explicit OnIncline(double tilt) {
    for (const Vec2 p : sheet.points) {
      start.positions.push_back({p.x * std::cos(tilt), p.y, 0.001 - p.x * std::sin(tilt)});
    }
  }
};

TEST(Contact, CarriesTheWeightOfAClothLyingFlat) {
  const test::Incline table(0, 0.3);
  const OnIncline cloth(0);
  const Drape drape = toile::drape(cloth.sheet.cloth, cotton(), &table, cloth.start, {.accuracy = 1e-6}, {});
  ASSERT_TRUE(drape.converged) << drape.trouble;
  EXPECT_NEAR(drape.contact.weight_N, 0.12 * 0.03 * standard_gravity, 1e-12);
  EXPECT_LT(drape.contact.weight_error, 1e-6);
  // A sheet that lies flat presses with its own weight per area, and sinks in by p / k.
  EXPECT_NEAR(drape.contact.pressure_Pa.mean, 0.12 * standard_gravity, 0.01);
  EXPECT_NEAR(drape.contact.max_penetration_m, drape.contact.pressure_Pa.max / table.spec().softness, 2e-7);
}

TEST(Contact, HoldsOnASlopeBelowTheAngleOfFriction) {
  const double tilt = 15 * std::numbers::pi / 180;  // tan = 0.268
  const test::Incline slope(tilt, 0.3);
  const OnIncline cloth(tilt);
  const Drape drape = toile::drape(cloth.sheet.cloth, cotton(), &slope, cloth.start, {.accuracy = 1e-4}, {});
  ASSERT_TRUE(drape.converged) << drape.trouble;
  EXPECT_LT(distance(drape.positions[0], cloth.start.positions[0]), 0.005);
  EXPECT_LT(drape.contact.weight_error, 1e-3);
}

TEST(Contact, SlidesOffASlopeAboveTheAngleOfFrictionAndSaysSo) {
  const double tilt = 19 * std::numbers::pi / 180;  // tan = 0.344
  const test::Incline slope(tilt, 0.3);
  const OnIncline cloth(tilt);
  const Drape drape =
      toile::drape(cloth.sheet.cloth, cotton(), &slope, cloth.start, {.accuracy = 1e-4, .max_iterations = 200}, {});
  EXPECT_FALSE(drape.converged);
  EXPECT_FALSE(drape.trouble.empty());
  EXPECT_GT(distance(drape.positions[0], cloth.start.positions[0]), 0.02);
  for (const Vec3& p : drape.positions) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
}

}  // namespace
}  // namespace toile
