#include "runtime/render/cloth_brdf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace toile {
namespace {

constexpr Vec3 kNormal{0, 0, 1};

Vec3 direction(double cosine, double azimuth) {
  const double sine = std::sqrt(1 - cosine * cosine);
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

/// What a viewer sees of a surface under a uniform sky of radiance 1.
Rgb under_white_sky(const ClothBrdf& brdf, double cos_view) {
  constexpr int kCosines = 200;
  constexpr int kAngles = 200;
  Rgb sum;
  for (int i = 0; i < kCosines; ++i) {
    const double cosine = (i + 0.5) / kCosines;
    for (int k = 0; k < kAngles; ++k) {
      const Vec3 light = direction(cosine, 2 * std::numbers::pi * (k + 0.5) / kAngles);
      sum += cosine * brdf(kNormal, light, direction(cos_view, 0));
    }
  }
  return 2 * std::numbers::pi / (kCosines * kAngles) * sum;
}

TEST(ClothBrdf, WhiteClothVanishesInAWhiteFurnace) {
  for (const double sheen : {0.0, 0.2, 0.6, 1.0}) {
    const ClothBrdf brdf(grey(1), grey(sheen));
    for (const double cosine : {0.08, 0.2, 0.4, 0.6, 0.8, 1.0}) {
      EXPECT_NEAR(under_white_sky(brdf, cosine).g, 1, 4e-3) << "sheen " << sheen << ", cosine " << cosine;
    }
  }
}

TEST(ClothBrdf, ColouredClothSendsBackLessThanItReceives) {
  const ClothBrdf brdf({0.5, 0.1, 0.0}, grey(0.3));
  for (const double cosine : {0.05, 0.3, 0.7, 1.0}) {
    const Rgb seen = under_white_sky(brdf, cosine);
    EXPECT_LT(seen.r, 1);
    EXPECT_LT(seen.g, seen.r);
    EXPECT_LT(seen.b, seen.g);
    EXPECT_GE(seen.b, 0);
  }
}

TEST(ClothBrdf, LightAndViewMayBeExchanged) {
  const ClothBrdf brdf({0.7, 0.4, 0.2}, {0.3, 0.2, 0.1});
  for (const double a : {0.1, 0.5, 0.9}) {
    for (const double b : {0.07, 0.4, 0.95}) {
      for (const double azimuth : {0.0, 1.0, 3.0}) {
        const Rgb there = brdf(kNormal, direction(a, 0), direction(b, azimuth));
        const Rgb back = brdf(kNormal, direction(b, azimuth), direction(a, 0));
        EXPECT_NEAR(there.r, back.r, 1e-12 * there.r);
        EXPECT_NEAR(there.b, back.b, 1e-12 * there.b);
      }
    }
  }
}

TEST(ClothBrdf, SheenIsStrongestAtGrazingAngles) {
  EXPECT_GT(sheen_albedo(0.1), 2 * sheen_albedo(0.9));
  for (int step = 0; step <= 20; ++step) EXPECT_LE(sheen_albedo(0.05 * step), 1);
}

TEST(ClothBrdf, NothingComesThroughFromBelow) {
  const ClothBrdf brdf(grey(1), grey(0.5));
  EXPECT_EQ(brdf(kNormal, direction(-0.2, 0), direction(0.5, 0)), Rgb{});
  EXPECT_EQ(brdf(kNormal, direction(0.2, 0), direction(-0.5, 0)), Rgb{});
}

}  // namespace
}  // namespace toile
