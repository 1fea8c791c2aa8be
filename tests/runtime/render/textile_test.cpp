#include <gtest/gtest.h>

#include "runtime/render/stripes.hpp"
#include "runtime/render/yarns.hpp"

namespace toile {
namespace {

constexpr Colour kRed{200, 0, 0};
constexpr Colour kGreen{0, 200, 0};
constexpr Colour kBlue{0, 0, 200};

void expect_near(Rgb a, Rgb b) {
  EXPECT_NEAR(a.r, b.r, 1e-9);
  EXPECT_NEAR(a.g, b.g, 1e-9);
  EXPECT_NEAR(a.b, b.b, 1e-9);
}

TEST(Stripes, LieWhereTheirWidthsPutThem) {
  const Stripes stripes({{kRed, 0.01}, {kGreen, 0.02}, {kBlue, 0.005}});
  for (const double repeat : {0.0, 0.035, -0.07, 3.5}) {
    expect_near(stripes.mean(repeat + 0.005, 1e-5), linear(kRed));
    expect_near(stripes.mean(repeat + 0.0101, 1e-5), linear(kGreen));
    expect_near(stripes.mean(repeat + 0.0299, 1e-5), linear(kGreen));
    expect_near(stripes.mean(repeat + 0.032, 1e-5), linear(kBlue));
  }
}

TEST(Stripes, MixInLinearLightOverAWidth) {
  const Stripes stripes({{kRed, 0.01}, {kGreen, 0.02}});
  expect_near(stripes.mean(0.01, 0.004), mix(linear(kRed), linear(kGreen), 0.5));
  expect_near(stripes.mean(0.0123, 0.03), mix(linear(kRed), linear(kGreen), 2.0 / 3));
  expect_near(stripes.mean(0.4, 100), stripes.mean());
}

TEST(Stripes, WithoutWidthOrAtAllAreSolid) {
  expect_near(Stripes({{kRed, 0.01}}).mean(0.7, 0.1), linear(kRed));
  expect_near(Stripes({{kBlue, 0}}).mean(0.7, 0.1), linear(kBlue));
  expect_near(Stripes({{kBlue, -1}, {kRed, 0.1}}).mean(0.7, 0.1), linear(kRed));
  EXPECT_GT(Stripes({}).mean(0, 0).r, 0);
}

TEST(TextileColour, WarpGoesByVAndWeftByU) {
  const Textile textile{"", {{kRed, 0.01}, {kBlue, 0.01}}, {{kGreen, 0.01}}};
  const TextileColour colour(textile);
  const Vec2 fine{1e-5, 1e-5};
  expect_near(colour.at({0.015, 0.005}, fine), mix(linear(kRed), linear(kGreen), 0.5));
  expect_near(colour.at({0.005, 0.015}, fine), mix(linear(kBlue), linear(kGreen), 0.5));
}

TEST(Yarns, AreFaintAndFadeFromAfar) {
  double sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const double shade = yarn_shade({0.00137 * i, 0.00071 * i}, {1e-4, 1e-4});
    EXPECT_NEAR(shade, 1, 0.2);
    sum += shade;
  }
  EXPECT_NEAR(sum / 10000, 1, 0.005) << "the cloth keeps its colour";
  EXPECT_EQ(yarn_shade({0.3, 0.2}, {0.1, 0.1}), 1);
  EXPECT_EQ(yarn_shade({1e300, 0.2}, {1e-4, 1e-4}), 1);
}

}  // namespace
}  // namespace toile
