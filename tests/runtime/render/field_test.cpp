#include "runtime/field/field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/drape/spread.hpp"
#include "runtime/render/field_scale.hpp"
#include "tests/runtime/render/scenes.hpp"

namespace toile {
namespace {

using ::testing::ElementsAre;

TEST(Field, EveryNameIsAFieldOfTheRightSize) {
  const Cloth cloth = test::square_cloth(3, 0.3);
  const Drape nothing_measured;
  EXPECT_EQ(field_names().size(), 10u);
  for (const std::string& name : field_names()) {
    const Field f = field(name, cloth, nothing_measured);
    EXPECT_EQ(f.name, name);
    EXPECT_FALSE(f.unit.empty());
    EXPECT_EQ(f.values.size(), f.per_vertex ? 16u : 18u);
  }
  EXPECT_EQ(field("strain.bias", cloth, nothing_measured).name, "");
}

TEST(Field, ReadsTheDrapeInItsUnit) {
  const Cloth cloth = test::square_cloth(1, 0.1);
  Drape drape;
  drape.strain_warp = {0.02, NAN};
  drape.shear_angle = {0.1, 0.2};
  drape.pressure = {1, 2, 3, 4};
  const Field strain = field("strain.warp", cloth, drape);
  EXPECT_DOUBLE_EQ(strain.values[0] * strain.to_unit, 2);
  EXPECT_EQ(strain.values[1], 0) << "what is not a number is not shown";
  const Field shear = field("strain.shear", cloth, drape);
  EXPECT_EQ(shear.unit, "deg");
  EXPECT_NEAR(shear.values[0] * shear.to_unit, 5.7296, 1e-4);
  EXPECT_THAT(field("contact.pressure", cloth, drape).values, ElementsAre(1, 2, 3, 4));
}

TEST(Field, VerticesTakeTheAreaWeightedMeanOfTheirTriangles) {
  const Cloth cloth = test::square_cloth(1, 1.0);  // two triangles: 0 1 3 and 0 3 2
  const Field f{.name = "x", .unit = "", .values = {1, 3}};
  EXPECT_THAT(at_vertices(f, cloth), ElementsAre(2, 1, 3, 2));
}

TEST(Spread, IsWeightedByArea) {
  const Spread s = spread({-1, 0, 10}, {1, 8, 1});
  EXPECT_DOUBLE_EQ(s.min, -1);
  EXPECT_DOUBLE_EQ(s.mean, 0.9);
  EXPECT_DOUBLE_EQ(s.max, 10);
  EXPECT_DOUBLE_EQ(s.p95, 10);
  EXPECT_DOUBLE_EQ(spread({-7, 0, 10}, {6, 92, 2}).p95, 7) << "of the absolute value";
}

TEST(Spread, OfNothingIsZeroAndWithoutAreasAllCountAlike) {
  EXPECT_EQ(spread({}, {}).max, 0);
  EXPECT_DOUBLE_EQ(spread({1, 2, 3}, {}).mean, 2);
}

FieldScale scale_of(const std::vector<double>& values, bool diverging, double to_unit = 1) {
  const Field f{
      .name = "f", .unit = "u", .to_unit = to_unit, .per_vertex = true, .values = values, .diverging = diverging};
  return FieldScale(f, values, std::vector<double>(values.size(), 1.0));
}

TEST(FieldScale, AFewWildValuesDoNotTakeTheColours) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(-0.02 + 0.05 * i / 999);
  values[500] = 40;
  const FieldScale scale = scale_of(values, true);
  EXPECT_NEAR(scale.high(), 0.03, 0.001);
  EXPECT_EQ(scale.low(), -scale.high());
  EXPECT_EQ(scale.greatest(), 40);
  EXPECT_EQ(scale.colour(40), scale.colour(scale.high()));
}

TEST(FieldScale, PressureStartsAtZeroAndLooksAtWhatTouches) {
  std::vector<double> values(1000, 0.0);
  for (int i = 0; i < 5; ++i) values[static_cast<std::size_t>(i)] = 200 + i;
  const FieldScale scale = scale_of(values, false);
  EXPECT_EQ(scale.low(), 0);
  EXPECT_EQ(scale.high(), 204);
}

TEST(FieldScale, ConstantAndEmptyFieldsHaveAScaleToo) {
  for (const auto& values : {std::vector<double>{}, std::vector<double>(9, 0.0), std::vector<double>(9, 3.5)}) {
    for (const bool diverging : {false, true}) {
      const FieldScale scale = scale_of(values, diverging);
      EXPECT_GT(scale.high(), scale.low());
      EXPECT_GE(scale.ticks().size(), 2u);
    }
  }
}

TEST(FieldScale, TicksAreRoundNumbersOfItsUnit) {
  const FieldScale scale = scale_of({-0.031, 0.02, 0.012}, true, 100);
  EXPECT_THAT(scale.ticks(), ElementsAre(-2, 0, 2));
  EXPECT_EQ(tick_label(-2, 2), "-2");
  EXPECT_EQ(tick_label(0.25, 0.05), "0.25");
  EXPECT_EQ(tick_label(1e-17, 0.1), "0");
  EXPECT_EQ(tick_label(150, 50), "150");
}

}  // namespace
}  // namespace toile
