#include "runtime/render/render.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <set>

#include "runtime/render/colour_map.hpp"
#include "runtime/render/scale_bar.hpp"
#include "runtime/render/stroke_font.hpp"
#include "tests/runtime/render/scenes.hpp"

namespace toile {
namespace {

using test::hung;
using test::SphereBody;
using test::square_cloth;

Colour at(const Image& image, int x, int y) {
  const auto i =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

RenderOptions small(View view = View::Front) {
  return {.width = 96, .height = 96, .view = view, .samples = 8};
}

Field ramp(const Cloth& cloth, bool diverging) {
  Field field{
      .name = "strain.warp", .unit = "%", .to_unit = 100, .per_vertex = true, .values = {}, .diverging = diverging};
  for (int i = 0; i < cloth.vertex_count; ++i)
    field.values.push_back((diverging ? -0.02 : 0) + 0.04 * i / cloth.vertex_count);
  return field;
}

bool is_picture(const Image& image, const RenderOptions& options) {
  const std::set<std::uint8_t> levels(image.rgb.begin(), image.rgb.end());
  return image.width == options.width && image.height == options.height &&
         image.rgb.size() ==
             std::size_t{3} * static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height) &&
         levels.size() > 1;
}

TEST(Render, DoesNotDependOnTheNumberOfThreads) {
  const Cloth cloth = square_cloth(16, 0.6);
  const auto positions = test::placed(16, [](double u, double v) {
    return Vec3{0.6 * (u - 0.5), 0.6 * (v - 0.5), 0.52 + 0.05 * std::sin(9 * u + 4 * v)};
  });
  const SphereBody ball({0, 0, 0.3}, 0.15, 20);
  const auto picture = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return render({{&cloth, &positions, {}, {}}}, &ball, small(View::ThreeQuarter)).rgb;
  };
  const auto one = picture(1);
  EXPECT_EQ(one, picture(2));
  EXPECT_EQ(one, picture(1));
}

TEST(Render, StripesLandWhereTheyAreInTheCloth) {
  const Cloth cloth = square_cloth(8, 0.2);
  const auto positions = hung(8, 0.2, 0.5);
  // Warp: v in the lower half red, in the upper half green. Weft: u in the left half black, in the right half blue.
  const Textile textile{
      "", {{Colour{220, 0, 0}, 0.1}, {Colour{0, 220, 0}, 0.1}}, {{Colour{0, 0, 0}, 0.1}, {Colour{0, 0, 220}, 0.1}}};
  const Image image = render({{&cloth, &positions, textile, {}}}, nullptr, small());
  const Colour low_left = at(image, 30, 66);
  const Colour low_right = at(image, 66, 66);
  const Colour high_left = at(image, 30, 30);
  const Colour high_right = at(image, 66, 30);
  EXPECT_GT(low_left.r, 3 * low_left.g);
  EXPECT_GT(low_right.r, 3 * low_right.g);
  EXPECT_GT(high_left.g, 3 * high_left.r);
  EXPECT_GT(high_right.g, 3 * high_right.r);
  EXPECT_GT(low_right.b, 3 * low_left.b);
  EXPECT_GT(high_right.b, 3 * high_left.b);
}

TEST(Render, SeamsShowAsGrooves) {
  Cloth cloth = square_cloth(2, 0.1);
  const auto positions = hung(2, 0.1, 0.5);
  const Image plain = render({{&cloth, &positions, {}, {}}}, nullptr, small());
  // The upright line in the middle, between vertices 1 and 4 and 4 and 7, is sewn.
  cloth.edges.resize(2);
  cloth.edges[0].seam = -1;
  cloth.edges[1].seam = 0;
  for (ClothTriangle& triangle : cloth.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = triangle.vertices[(c + 1) % 3];
      const int b = triangle.vertices[(c + 2) % 3];
      triangle.edges[c] = a % 3 == 1 && b % 3 == 1 ? 1 : 0;
    }
  }
  const Image sewn = render({{&cloth, &positions, {}, {}}}, nullptr, small());
  for (const int y : {30, 44, 60}) {
    EXPECT_LT(at(sewn, 48, y).g + 12, at(plain, 48, y).g);
    EXPECT_NEAR(at(sewn, 38, y).g, at(plain, 38, y).g, 1);
  }
}

TEST(Render, ClothOnABodyIsNotPierced) {
  // A coarse red cap whose vertices lie exactly on the ball: its chords run through the ball's flesh.
  const int n = 14;
  const Cloth cloth = square_cloth(n, 0.2);
  const double radius = 0.15;
  const auto positions = test::placed(n, [&](double u, double v) {
    const Vec3 flat{0.2 * (u - 0.5), 0.2 * (v - 0.5), 0};
    const double angle = norm(flat) / radius;
    const Vec3 side = norm(flat) > 0 ? normalized(flat) : Vec3{};
    return Vec3{0, 0, 0.3} + radius * (std::sin(angle) * side + Vec3{0, 0, std::cos(angle)});
  });
  const SphereBody ball({0, 0, 0.3}, radius, 80);
  const Textile red{"", {{Colour{200, 0, 0}, 0.1}}, {{Colour{200, 0, 0}, 0.1}}};
  const Image image = render({{&cloth, &positions, red, {}}}, &ball, small(View::Above));
  for (int y = 30; y < 66; ++y) {
    for (int x = 30; x < 66; ++x) EXPECT_GT(at(image, x, y).r, 2 * at(image, x, y).g) << x << ' ' << y;
  }
}

TEST(Render, EmptyScenesAreBackdrop) {
  EXPECT_TRUE(is_picture(render({}, nullptr, small()), small()));
  const Cloth cloth = square_cloth(2, 0.2);
  const std::vector<Vec3> too_few(3);
  EXPECT_EQ(render({{&cloth, &too_few, {}, {}}}, nullptr, small()).rgb, render({}, nullptr, small()).rgb);
  EXPECT_EQ(render({DressedCloth{}}, nullptr, small()).rgb, render({}, nullptr, small()).rgb);
}

TEST(Render, SizeOfTheSceneDoesNotMatter) {
  for (const double side : {1e-5, 0.3, 4e4}) {
    const Cloth cloth = square_cloth(6, side);
    const auto positions = hung(6, side, 2 * side);
    const Textile black{"", {{Colour{0, 0, 0}, 1}}, {{Colour{0, 0, 0}, 1}}};
    const Image image = render({{&cloth, &positions, black, {}}}, nullptr, small());
    EXPECT_LT(at(image, 48, 48).g, 70) << "the cloth is in the middle, side " << side;
    EXPECT_GT(at(image, 48, 2).g, 180) << "and the backdrop round it";
  }
}

TEST(Render, BadNumbersLeaveHolesAndNothingWorse) {
  const Cloth cloth = square_cloth(6, 0.3);
  auto positions = hung(6, 0.3, 0.5);
  positions[20] = {NAN, 0, 0};
  positions[33].z = INFINITY;
  Field field = ramp(cloth, true);
  field.values[5] = NAN;
  EXPECT_TRUE(is_picture(render({{&cloth, &positions, {}, field}}, nullptr, small()), small()));
  const std::vector<Vec3> all_the_same(static_cast<std::size_t>(cloth.vertex_count), Vec3{0, 0, 1});
  EXPECT_TRUE(is_picture(render({{&cloth, &all_the_same, {}, {}}}, nullptr, small()), small()));
  const RenderOptions none{.width = -5, .height = 0, .samples = -3};
  EXPECT_EQ(render({{&cloth, &positions, {}, {}}}, nullptr, none).rgb.size(), 3u);
}

TEST(ScaleBar, ColoursGrowLighterUpwards) {
  const Cloth cloth = square_cloth(6, 0.3);
  const auto positions = hung(6, 0.3, 0.5);
  const RenderOptions options{.width = 200, .height = 200, .view = View::Front, .samples = 4};
  const Image image = render({{&cloth, &positions, {}, ramp(cloth, false)}}, nullptr, options);
  const BarPlace bar = scale_bar_place(200, 200);
  double before = 0;
  for (int y = bar.bottom - 1; y >= bar.top; --y) {
    const double here = lightness(linear(at(image, (bar.left + bar.right) / 2, y)));
    EXPECT_GE(here, before - 0.005) << "row " << y;
    before = here;
  }
  EXPECT_GT(before, 0.85);
}

TEST(ScaleBar, TheFieldsColourIsOnTheCloth) {
  const Cloth cloth = square_cloth(6, 0.3);
  const auto positions = hung(6, 0.3, 0.5);
  const Image image = render({{&cloth, &positions, {}, ramp(cloth, true)}}, nullptr, small());
  const Colour low = at(image, 40, 70);  // v, and with it the value, grows upwards
  const Colour high = at(image, 40, 26);
  EXPECT_GT(low.b, low.r + 40);
  EXPECT_GT(high.r, high.b + 40);
}

TEST(StrokeFont, HasEveryLetterOfFieldsAndUnits) {
  const auto box = text_strokes("?");
  for (const std::string& name : field_names()) {
    for (const char c : name + "%N/mPadeg1/m min max in -0123456789.e+") {
      if (c == ' ') continue;
      const auto strokes = text_strokes(std::string(1, c));
      EXPECT_FALSE(strokes.empty()) << c;
      EXPECT_NE(strokes, box) << c;
    }
  }
  EXPECT_EQ(text_strokes("\xC2\xB0").size(), 1u) << "a degree sign is one ring";
  EXPECT_GT(text_width("mm"), text_width("m"));
  EXPECT_EQ(text_width(""), 0);
}

}  // namespace
}  // namespace toile
