// What light does in the studio: energy, shadows, sampling and smoothing.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "runtime/render/exposure.hpp"
#include "tests/runtime/render/scenes.hpp"

namespace toile {
namespace {

constexpr int kSize = 64;

struct Look {
  Stage stage;
  Camera camera;
  Look(const std::vector<DressedCloth>& cloths, const Body* body, View view)
      : stage(cloths, body), camera(aim(view), {0, 0, kSize, kSize}, stage.framed(), 0.2) {}
  std::vector<Pixel> pixels(const Studio& studio, int samples) const {
    return expose(stage, studio, camera, kSize, kSize, samples);
  }
};

TEST(Light, WhiteFoldedClothUnderAWhiteSkyIsNeitherDarkerNorBrighter) {
  const int n = 24;
  const Cloth cloth = test::square_cloth(n, 0.4);
  const auto positions = test::placed(n, [](double u, double v) {
    return Vec3{0.4 * (u - 0.5), 0.03 * std::sin(25 * u), 0.4 * v + 0.2};
  });
  const Textile white{"", {{Colour{255, 255, 255}, 0.01}}, {{Colour{255, 255, 255}, 0.01}}};
  const Look look({{&cloth, &positions, white, {}}}, nullptr, View::Front);
  double seen = 0;
  double albedo = 0;
  int count = 0;
  for (const Pixel& p : look.pixels(Studio::furnace(), 64)) {
    if (p.cloth < 1) continue;
    seen += p.colour[1] * p.light[1];
    albedo += p.colour[1];  // white less the yarns' shade
    ++count;
  }
  ASSERT_GT(count, 500);
  EXPECT_LE(seen / count, 1.002);
  EXPECT_GE(seen / count, albedo / count - 0.002);
  EXPECT_GT(albedo / count, 0.95);
}

TEST(Light, FloorIsBackdropInTheOpenAndDarkUnderTheSubject) {
  const test::SphereBody ball({0, 0, 0.2}, 0.2, 24);
  const Look look({}, &ball, View::Front);
  const auto pixels = look.pixels(Studio(aim(View::Front)), 16);
  double darkest = 1;
  int open = 0;
  for (const Pixel& p : pixels) {
    if (p.form > 0) continue;
    darkest = std::min<double>(darkest, p.light[1]);
    if (p.light[1] == 1) ++open;
    EXPECT_LE(p.light[1], 1 + 1e-6);
    EXPECT_GE(p.light[1], 0);
  }
  EXPECT_LT(darkest, 0.5);
  EXPECT_GT(open, kSize * kSize / 4);
}

TEST(Light, TheSideOfTheKeyLightIsBrighter) {
  const test::SphereBody ball({0, 0, 0.2}, 0.2, 24);
  const Look look({}, &ball, View::Front);
  const auto pixels = look.pixels(Studio(aim(View::Front)), 16);
  const auto light = [&](double x, double y) {
    return pixels[static_cast<std::size_t>(y * kSize) * kSize + static_cast<std::size_t>(x * kSize)].light[1];
  };
  EXPECT_GT(light(0.35, 0.35), 1.5f * light(0.68, 0.62));
}

TEST(Samples, FillTheirStrata) {
  const SampleTable table(16);
  for (int pixel = 0; pixel < 50; ++pixel) {
    for (const Purpose purpose : {Purpose::Lens, Purpose::KeyLight, Purpose::Dome}) {
      std::set<int> squares;
      std::set<int> columns;
      for (int i = 0; i < 16; ++i) {
        const Sample2 s = table.at(SampleTable::pixel_seed(pixel, 7), i, purpose);
        ASSERT_TRUE(s.x >= 0 && s.x < 1 && s.y >= 0 && s.y < 1);
        squares.insert(static_cast<int>(4 * s.x) + 4 * static_cast<int>(4 * s.y));
        columns.insert(static_cast<int>(16 * s.x));
      }
      EXPECT_EQ(squares.size(), 16u);
      EXPECT_EQ(columns.size(), 16u);
    }
  }
}

TEST(Samples, DirectionsFollowTheirAxis) {
  const Vec3 axis = normalized({0.3, -0.5, -0.8});
  const SampleTable table(256);
  Vec3 mean;
  for (int i = 0; i < 256; ++i) {
    const Sample2 s = table.at(5, i, Purpose::Dome);
    const Vec3 d = cosine_direction(Frame(axis), s);
    EXPECT_NEAR(norm(d), 1, 1e-9);
    EXPECT_GE(dot(d, axis), 0);
    mean += d / 256;
    EXPECT_GE(dot(cone_direction(Frame(axis), 0.97, s), axis), 0.97 - 1e-9);
  }
  EXPECT_NEAR(dot(mean, axis), 2.0 / 3, 0.01);  // of a cosine-weighted hemisphere
}

/// A field of pixels facing the camera, on a plane.
std::vector<Pixel> wall() {
  std::vector<Pixel> pixels(kSize * kSize);
  for (int i = 0; i < kSize * kSize; ++i) {
    const int column = i % kSize, row = i / kSize;
    Pixel& p = pixels[static_cast<std::size_t>(i)];
    p.normal = {0, -1, 0};
    p.position = {0.01f * static_cast<float>(column), 0, 0.01f * static_cast<float>(row)};
    p.cloth = 1;
    p.light = {0.5f, 0.5f, 0.5f};
  }
  return pixels;
}

TEST(Denoise, TakesNoiseAwayAndKeepsAShadowsEdge) {
  std::vector<Pixel> pixels = wall();
  const SampleTable noise(kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      Pixel& p = pixels[static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)];
      const auto jitter = static_cast<float>(0.1 * (noise.at(SampleTable::pixel_seed(x, y), x, Purpose::Dome).x - 0.5));
      const float level = (x < kSize / 2 ? 0.2f : 1.0f) + jitter;
      p.light = {level, level, level};
      p.variance = 0.01f / 12;
    }
  }
  smooth_light(pixels, kSize, kSize);
  for (int y = 8; y < kSize - 8; ++y) {
    for (int x = 8; x < kSize - 8; ++x) {
      const float truth = x < kSize / 2 ? 0.2f : 1.0f;
      EXPECT_NEAR(pixels[static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)].light[0], truth, 0.035)
          << x << ' ' << y;
    }
  }
}

TEST(Denoise, LeavesWhatIsCertainAlone) {
  std::vector<Pixel> pixels = wall();
  pixels[700].light = {0.9f, 0.1f, 0.3f};
  const std::vector<Pixel> before = pixels;
  smooth_light(pixels, kSize, kSize);
  for (std::size_t i = 0; i < pixels.size(); ++i) EXPECT_EQ(pixels[i].light, before[i].light);
}

}  // namespace
}  // namespace toile
