#include "runtime/export/textile_image.hpp"

#include <gtest/gtest.h>

namespace toile {
namespace {

Colour texel(const Image& image, int column, int row) {
  const std::size_t at = 3 * static_cast<std::size_t>(row * image.width + column);
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

TEST(TextileImage, SolidClothIsOneTexelOfItsColour) {
  const Colour grey{100, 120, 140};
  const TextileImage solid = textile_image({"solid", {{grey, 0.01}}, {{grey, 0.02}}});
  EXPECT_EQ(solid.image.width * solid.image.height, 1);
  EXPECT_EQ(texel(solid.image, 0, 0), grey);
  EXPECT_DOUBLE_EQ(solid.repeat_u, 0.02);
  EXPECT_DOUBLE_EQ(solid.repeat_v, 0.01);
}

// Warp threads run along u and are told apart across it: stripes of warp colours vary along v, that is by rows.
TEST(TextileImage, WarpStripesVaryByRowsAndMixWithTheWeftAsLight) {
  const Colour black{0, 0, 0}, white{255, 255, 255};
  const TextileImage striped = textile_image({"striped", {{black, 0.01}, {white, 0.01}}, {{white, 0.05}}});
  EXPECT_EQ(striped.image.width, 1);
  ASSERT_GE(striped.image.height, 8);
  EXPECT_EQ(texel(striped.image, 0, 0), (Colour{188, 188, 188}));  // half the light of white
  EXPECT_EQ(texel(striped.image, 0, striped.image.height - 1), white);
  EXPECT_NEAR(striped.mean[0], 0.75, 1e-12);
}

TEST(TextileImage, StripesKeepTheirShareOfTheRepeatWhereverTheyEnd) {
  const Colour black{0, 0, 0}, white{255, 255, 255};
  const TextileImage check =
      textile_image({"check", {{white, 0.007}, {black, 0.0031}}, {{white, 0.007}, {black, 0.0031}}});
  EXPECT_NEAR(check.mean[1], 0.007 / 0.0101, 1e-12);
  EXPECT_EQ(texel(check.image, 0, 0), white);
  EXPECT_EQ(texel(check.image, check.image.width - 1, check.image.height - 1), black);
  EXPECT_EQ(texel(check.image, 0, check.image.height - 1), texel(check.image, check.image.width - 1, 0));
}

TEST(TextileImage, ATextileWithoutThreadsStillHasAPicture) {
  const TextileImage none = textile_image({"none", {}, {{Colour{}, 0.0}}});
  EXPECT_EQ(none.image.rgb.size(), 3U);
  EXPECT_GT(none.repeat_u, 0);
}

}  // namespace
}  // namespace toile
