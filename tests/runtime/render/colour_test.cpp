#include "runtime/render/colour.hpp"

#include <gtest/gtest.h>

#include "runtime/render/colour_map.hpp"

namespace toile {
namespace {

TEST(Colour, EightBitsSurviveTheWayToLightAndBack) {
  for (int i = 0; i < 256; ++i) {
    const auto level = static_cast<std::uint8_t>(i);
    const Colour colour{level, static_cast<std::uint8_t>(255 - i), 128};
    EXPECT_EQ(srgb(linear(colour)), colour);
  }
}

TEST(Colour, ToneKeepsMiddleTonesAndNeverFalls) {
  EXPECT_DOUBLE_EQ(tone(0.18), 0.18);
  double before = -1;
  for (int step = 0; step < 2000; ++step) {
    const double light = 0.01 * step;
    const double now = tone(light);
    EXPECT_LE(now, 1);
    EXPECT_TRUE(now > before || light > 3);
    before = now;
  }
}

TEST(ColourMap, SequentialGrowsLighterInEqualSteps) {
  constexpr int kSteps = 32;
  double least = 1;
  double most = 0;
  for (int i = 0; i < kSteps; ++i) {
    const Rgb here = sequential_colour(static_cast<double>(i) / kSteps);
    const Rgb next = sequential_colour(static_cast<double>(i + 1) / kSteps);
    EXPECT_GT(lightness(next), lightness(here));
    least = std::min(least, colour_difference(here, next));
    most = std::max(most, colour_difference(here, next));
  }
  EXPECT_LT(most / least, 1.25);
}

TEST(ColourMap, DivergingIsLightestAtZeroBlueBelowAndRedAbove) {
  for (int i = 0; i < 32; ++i) {
    const double t = i / 32.0;
    EXPECT_GT(lightness(diverging_colour(t)), lightness(diverging_colour(t + 1 / 32.0)));
    EXPECT_GT(lightness(diverging_colour(-t)), lightness(diverging_colour(-t - 1 / 32.0)));
  }
  EXPECT_NEAR(lightness(diverging_colour(1)), lightness(diverging_colour(-1)), 0.02);
  EXPECT_GT(diverging_colour(1).r, 3 * diverging_colour(1).b);
  EXPECT_GT(diverging_colour(-1).b, 3 * diverging_colour(-1).r);
  EXPECT_LT(colour_difference(diverging_colour(-1e-9), diverging_colour(1e-9)), 0.02);
}

TEST(ColourMap, ClampsBeyondItsEnds) {
  EXPECT_EQ(sequential_colour(-3), sequential_colour(0));
  EXPECT_EQ(sequential_colour(7), sequential_colour(1));
  EXPECT_EQ(diverging_colour(-7), diverging_colour(-1));
}

}  // namespace
}  // namespace toile
