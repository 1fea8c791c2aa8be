// Units as written, and quantities as people read them.
#include <gmock/gmock.h>

#include <numbers>

#include "compiler/diag/nearest.hpp"
#include "compiler/units/format.hpp"
#include "compiler/units/unit.hpp"

namespace toile {
namespace {

TEST(Units, KesUnitsConvertToSi) {
  EXPECT_NEAR(parse_unit("gf*cm/cm^2")->factor, 0.980665, 1e-12);
  EXPECT_NEAR(parse_unit("gf/cm/deg")->factor, 0.980665 * 180 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(parse_unit("gf/cm")->factor, 0.980665, 1e-12);
  EXPECT_NEAR(parse_unit("gf*cm^2/cm")->factor, 9.80665e-5, 1e-16);
  EXPECT_NEAR(parse_unit("gf*cm/cm")->factor, 9.80665e-3, 1e-14);
  EXPECT_NEAR(parse_unit("mg/cm^2")->factor, 0.01, 1e-15);
}

TEST(Units, CompoundsHaveTheDimensionOfTheirParts) {
  EXPECT_EQ(parse_unit("gf*cm^2/cm")->dimension, dimension::energy);
  EXPECT_EQ(parse_unit("mg/cm^2")->dimension, dimension::area_weight);
  EXPECT_EQ(parse_unit("N/m^3")->dimension, dimension::softness);
  EXPECT_EQ(parse_unit("gf/cm/deg")->dimension, dimension::shear_stiffness);
}

TEST(Units, UnknownPartIsNamed) {
  EXPECT_FALSE(parse_unit("gf*ft"));
  EXPECT_EQ(unknown_unit_part("gf*ft"), "ft");
  EXPECT_FALSE(parse_unit(""));
  EXPECT_FALSE(parse_unit("cm^"));
  EXPECT_FALSE(parse_unit("cm^99"));
}

TEST(Units, QuantitiesAreShownAsPeopleExpect) {
  using namespace dimension;
  EXPECT_EQ(format_quantity(0.68, length), "68 cm");
  EXPECT_EQ(format_quantity(0.0123, length), "1.23 cm");
  EXPECT_EQ(format_quantity(0.002, length), "2 mm");
  EXPECT_EQ(format_quantity(2e-6, length), "2 um");
  EXPECT_EQ(format_quantity(-0.68, length), "-68 cm");
  EXPECT_EQ(format_quantity(0, length), "0 cm");
  EXPECT_EQ(format_quantity(std::numbers::pi / 6, angle), "30 deg");
  EXPECT_EQ(format_quantity(0.042, number, true), "4.2 %");
  EXPECT_EQ(format_quantity(1.0 / 3, number), "0.333333");
  EXPECT_EQ(format_quantity(-0.0, number), "0");
  EXPECT_EQ(format_quantity(0.192, area_weight), "192 g/m^2");
  EXPECT_EQ(format_quantity(3, force * length * length), "3 kg*m^3/s^2");
}

TEST(Nearest, SlipsAreRecognisedAndStrangersAreNot) {
  const std::vector<std::string> known{"waist", "hip", "length"};
  EXPECT_EQ(nearest("wiast", known), "waist");
  EXPECT_EQ(nearest("lenght", known), "length");
  EXPECT_EQ(nearest("Waist", known), "waist");
  EXPECT_EQ(nearest("collar", known), std::nullopt);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

}  // namespace
}  // namespace toile
