// The pattern's change by the sensitivity of the equilibrium, on a strip of cloth that hangs between its held ends.
#include "runtime/develop/pattern_step.hpp"

#include <gtest/gtest.h>

#include "runtime/drape/drape.hpp"
#include "tests/support/sheet.hpp"

namespace toile {
namespace {

FabricSheet worsted() {
  FabricSheet sheet;
  sheet.emt = WarpWeft{0.045, 0.06};
  sheet.lt = WarpWeft{0.6, 0.65};
  sheet.g = WarpWeft{33.7, 33.7};
  sheet.b = WarpWeft{7e-6, 5e-6};
  sheet.weight = 0.19;
  return sheet;
}

/// A strip of 12 x 4 cells whose ends are held 25 cm apart, whatever its pattern.
class HangingStrip {
 public:
  HangingStrip() {
    const test::Sheet sheet = test::rectangle(0.3, 0.1, 12, 4);
    pattern = sheet.points;
    for (const ClothTriangle& triangle : sheet.cloth.triangles) mesh.triangles.push_back(triangle.vertices);
    mesh.vertex_count = sheet.cloth.vertex_count;
    plane.triangles = mesh.triangles;
    plane.start = pattern;
    plane.grain = {{26, 38}};  // the middle row
    for (std::size_t v = 0; v < pattern.size(); ++v) {
      const Vec2 p = pattern[v];
      start.positions.push_back({0.25 / 0.3 * p.x, p.y, -0.6 * p.x * (0.3 - p.x)});
      if (p.x < 1e-9 || p.x > 0.3 - 1e-9) start.held.push_back(static_cast<int>(v));
    }
  }

  Drape drape(const std::vector<Vec2>& uv, const std::function<void(const RestState&)>& at_rest = {}) const {
    DrapeOptions options;
    options.accuracy = 1e-7;
    options.at_rest = at_rest;
    return toile::drape(test::cloth_of(uv, mesh.triangles), worsted(), nullptr, start, options, {});
  }

  SMesh mesh;
  FlatteningInput plane;
  std::vector<Vec2> pattern;
  Placed start;
};

TEST(PatternStep, BringsAStripToTheFormOfALongerOneInAFewDrapes) {
  const HangingStrip strip;
  std::vector<Vec2> longer = strip.pattern;
  for (Vec2& p : longer) p.x *= 1.04;
  const Drape form = strip.drape(longer);
  ASSERT_TRUE(form.converged);

  std::vector<Vec2> uv = strip.pattern;
  std::vector<double> misses;
  for (int round = 0; round < 5; ++round) {
    PatternStep step;
    const Cloth cloth = test::cloth_of(uv, strip.mesh.triangles);
    strip.drape(uv, [&](const RestState& rest) {
      std::vector<Vec3> draped;
      for (int v = 0; v < strip.mesh.vertex_count; ++v) draped.push_back(to_vec3(rest.q.segment<3>(3 * v)));
      const FormDistance found = form_distance(strip.mesh, form.positions, draped, cloth.area_of_vertex);
      misses.push_back(missed(cloth, found));
      step = pattern_step(strip.plane, uv, cloth, rest, found, 1e-6);
    });
    ASSERT_FALSE(step.change.empty());
    EXPECT_LT(step.left, 0.5);
    uv = changed_pattern(strip.plane, uv, step.change);
  }
  EXPECT_GT(misses.front(), 3e-3);
  EXPECT_LT(misses.back(), 0.01 * misses.front());
}

TEST(PatternStep, PromisesWhatASmallChangeThenDoes) {
  const HangingStrip strip;
  std::vector<Vec2> longer = strip.pattern;
  for (Vec2& p : longer) p.x *= 1.001;
  const Drape form = strip.drape(longer);
  PatternStep step;
  double before = 0, after = 0;
  const auto found = [&](const RestState& rest, const Cloth& cloth) {
    std::vector<Vec3> draped;
    for (int v = 0; v < strip.mesh.vertex_count; ++v) draped.push_back(to_vec3(rest.q.segment<3>(3 * v)));
    return form_distance(strip.mesh, form.positions, draped, cloth.area_of_vertex);
  };
  const Cloth cloth = test::cloth_of(strip.pattern, strip.mesh.triangles);
  strip.drape(strip.pattern, [&](const RestState& rest) {
    before = missed(cloth, found(rest, cloth));
    step = pattern_step(strip.plane, strip.pattern, cloth, rest, found(rest, cloth), 0.1);
  });
  strip.drape(changed_pattern(strip.plane, strip.pattern, step.change),
              [&](const RestState& rest) { after = missed(cloth, found(rest, cloth)); });
  EXPECT_GT(step.left, 0.05);
  EXPECT_NEAR(after / before, step.left, 0.1 * step.left);
}

}  // namespace
}  // namespace toile
