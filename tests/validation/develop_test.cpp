// Development against closed forms: docs/develop.md has the figures.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "runtime/drape/drape.hpp"
#include "tests/support/flat_region.hpp"
#include "tests/support/hemisphere.hpp"
#include "tests/support/sheet.hpp"

namespace toile {
namespace {

using std::numbers::pi;
using test::grid;
using test::isotropic;
using test::largest_strain;
using test::orthotropic;
using test::region;
using test::Surface;
using test::total;

constexpr double modulus = 1000;  // [N/m]

/// x along the girth, y up.
Surface cylinder(double radius) {
  return [radius](Vec2 p) { return Vec3{radius * std::sin(p.x / radius), -radius * std::cos(p.x / radius), p.y}; };
}
/// A cone cut open and laid flat has its tip at the origin; angles there are `ratio` times those about its axis.
Surface cone(double ratio) {
  return [ratio](Vec2 p) {
    const double away = norm(p), around = std::atan2(p.y, p.x) / ratio;
    return Vec3{away * ratio * std::cos(around), away * ratio * std::sin(around), -away * std::sqrt(1 - ratio * ratio)};
  };
}
/// Lengths and directions from the pole are kept.
Surface cap(double radius) {
  return [radius](Vec2 p) {
    const double away = norm(p), off = away / radius;
    const double in_plane = away > 0 ? radius * std::sin(off) / away : 1;
    return Vec3{in_plane * p.x, in_plane * p.y, radius * std::cos(off)};
  };
}
/// Lengths along the equator, and on the meridians that cross it, are kept.
Surface belt(double radius) {
  return [radius](Vec2 p) {
    const double along = p.x / radius, off = p.y / radius;
    return Vec3{radius * std::cos(off) * std::sin(along), -radius * std::cos(off) * std::cos(along),
                radius * std::sin(off)};
  };
}

void expect_sound(const Flattened& flat) {
  EXPECT_TRUE(flat.converged) << flat.residual_relative;
  EXPECT_EQ(flat.flipped, 0);
}

Flattened solve(const FlatteningInput& input, const FabricLaw& law) {
  Flattened flat = flatten(input, law, {}, {});
  expect_sound(flat);
  return flat;
}

TEST(DevelopCylinder, IsExactWhereEdgesFollowTheRulings) {
  FlatteningInput input = grid(0.3, 0.2, 24, 12, cylinder(0.1));
  for (Vec2& p : input.start) p = {1.3 * p.x + 0.1 * p.y, 0.8 * p.y};  // far from it
  const Flattened flat = solve(input, orthotropic(2000, 900, 60));
  EXPECT_LT(largest_strain(flat), 1e-6);
  EXPECT_LT(total(flat), 1e-12);
}

TEST(DevelopCone, IsExactWhereEdgesFollowTheRulings) {
  // A grid of rulings and rings: x along the ruling, y the angle about the tip.
  const double ratio = 0.5;
  const Surface unrolled = cone(ratio);
  const auto fan = [&](Vec2 p) { return unrolled((0.1 + p.x) * direction(p.y)); };
  const Flattened flat = solve(grid(0.2, 1.2, 12, 24, fan), orthotropic(2000, 900, 60));
  EXPECT_LT(largest_strain(flat), 1e-6);
}

struct Developable {
  const char* name;
  Surface surface;
  Curve outline;
};

TEST(DevelopableSurfaces, HaveStrainsAndLengthErrorsThatFallWithTheSquareOfTheEdge) {
  const Curve outline = circle({0.25, 0.02}, {0.33, 0.02});
  for (const Developable& each : {Developable{"cylinder", cylinder(0.1), outline}, {"cone", cone(0.6), outline}}) {
    double strain_before = 0, error_before = 0;
    for (const double edge : {0.016, 0.008, 0.004}) {
      const FlatteningInput input = region(each.outline, edge, each.surface);
      const Flattened flat = solve(input, orthotropic(2000, 900, 60));
      double drawn = 0;
      for (const auto& t : input.triangles) {
        const auto at = [&](std::size_t k) { return input.start[static_cast<std::size_t>(t[k])]; };
        drawn += 0.5 * cross(at(1) - at(0), at(2) - at(0));
      }
      const double error = std::abs(flat.area / drawn - 1);
      const double strain = std::sqrt(2 * total(flat) / (1000 * flat.area));
      std::printf("%s: edges of %.0f mm, strain %.2e, area off by %.2e\n", each.name, 1000 * edge, strain, error);
      if (strain_before > 0) {
        EXPECT_GT(strain_before / strain, 3) << each.name << " at " << edge;
        EXPECT_GT(error_before / error, 3) << each.name << " at " << edge;
      }
      strain_before = strain;
      error_before = error;
    }
    EXPECT_LT(strain_before, 1e-3);
  }
}

TEST(DevelopCap, HasTheEnergyOfTheShallowCap) {
  const double a = 0.1, radius = 1.5;
  const double theory = pi * modulus * std::pow(a, 6) / (384 * std::pow(radius, 4));
  double error_before = 0;
  for (const double edge : {0.02, 0.01, 0.005, 0.0025}) {
    const FlatteningInput input = region(circle({0, 0}, {a, 0}), edge, cap(radius));
    const double error = std::abs(total(solve(input, isotropic(modulus))) / theory - 1);
    std::printf("cap: edges of a/%.0f, energy off by %.2f %%\n", a / edge, 100 * error);
    if (error_before > 0) {
      EXPECT_LT(error, 0.6 * error_before);
    }
    error_before = error;
  }
  EXPECT_LT(error_before, 0.005);
}

/// A strip along a great circle, 2 w wide: the strain along it is (w^2/3 - y^2) / 2 R^2, so that the energy of a length
/// is Y w^5 / 45 R^4. Two lengths leave out what the ends add.
TEST(DevelopBelt, HasTheEnergyOfTheNarrowStrip) {
  const double w = 0.05, radius = 1.5;
  const auto energy = [&](double length, int rows) {
    const int columns = static_cast<int>(std::lround(length / (2 * w) * rows));
    FlatteningInput input = grid(length, 2 * w, columns, rows, [&](Vec2 p) {
      return belt(radius)({p.x - length / 2, p.y - w});
    });
    return total(solve(input, isotropic(modulus)));
  };
  const double theory = modulus * std::pow(w, 5) / (45 * std::pow(radius, 4));
  double error_before = 0;
  for (const int rows : {16, 32, 64}) {
    const double error = std::abs((energy(0.5, rows) - energy(0.4, rows)) / 0.1 / theory - 1);
    std::printf("belt: %d rows, energy off by %.2f %%\n", rows, 100 * error);
    if (error_before > 0) {
      EXPECT_LT(error, 0.3 * error_before);
    }
    error_before = error;
  }
  EXPECT_LT(error_before, 0.005);
}

/// A gore between two meridians, w0 = pi R / n wide to each side at the equator, has the sum of its strips' energies,
/// while it is slender: all n of them together fall with the fourth power of n.
TEST(DevelopGores, FallWithTheFourthPowerOfTheirNumber) {
  const double radius = 0.15;
  const auto all_gores = [&](int n) {
    const double w0 = pi * radius / n, top = 1.2 * radius;
    const Surface gore = [&](Vec2 p) {
      const double up = (p.x - top) / radius, around = (2 * p.y - 1) * pi / n;
      return Vec3{radius * std::cos(up) * std::sin(around), -radius * std::cos(up) * std::cos(around),
                  radius * std::sin(up)};
    };
    FlatteningInput input = grid(2 * top, 1, 12 * n, 32, gore);
    for (Vec2& p : input.start) p.y = (2 * p.y - 1) * w0 * std::cos((p.x - top) / radius);
    return n * total(solve(input, isotropic(modulus)));
  };
  const double few = all_gores(24), many = all_gores(48);
  std::printf("gores: from 24 to 48 the energy falls with the power %.2f\n", std::log2(few / many));
  EXPECT_NEAR(std::log2(few / many), 4, 0.1);
  // The integral of w^5 over the height.
  double integral = 0;
  const int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    integral += std::pow(pi * radius / 48 * std::cos(2.4 * ((i + 0.5) / steps - 0.5)), 5) * 2.4 * radius / steps;
  }
  EXPECT_NEAR(many / (48 * modulus * integral / (45 * std::pow(radius, 4))), 1, 0.03);
}

/// n darts make a hemisphere n gores that hang together about the pole. As they become slender they come to have the
/// sum of their strips' energies, as above, which falls with the fourth power of n.
TEST(DevelopHemisphere, WithManyDartsHasTheEnergyOfItsGores) {
  const double radius = 0.15;
  double before = 0, share_before = 0;
  for (const int n : {8, 16, 32}) {
    const int rings = n > 16 ? 96 : 48;
    FlatteningInput input = test::hemisphere_with_darts(radius, n, rings, rings / n, n > 8 ? 12 : 16);
    input.matches.clear();  // both sides of a dart are alike by themselves
    const Flattened flat = solve(input, isotropic(modulus));
    double integral = 0;  // of w^5 over the meridian
    const int steps = 1000;
    for (int i = 0; i < steps; ++i) {
      const double off = pi / 2 * (i + 0.5) / steps;
      integral += std::pow(pi * radius / n * std::sin(off), 5) * pi / 2 * radius / steps;
    }
    const double share = total(flat) / (n * modulus * integral / (45 * std::pow(radius, 4)));
    const double power = before > 0 ? std::log2(before / total(flat)) : 0;
    std::printf("hemisphere: %d darts leave %.4g J, %.3f of the slender gores'; the power is %.2f\n", n, total(flat),
                share, power);
    EXPECT_GT(share, share_before);
    if (n == 32) {
      EXPECT_NEAR(share, 1, 0.05);
      EXPECT_GT(power, 3.6);
    }
    before = total(flat);
    share_before = share;
  }
}

/// The same cap in a cloth that is firm along the warp and soft across, with its grain at three angles: three patterns,
/// each the best in its own energy.
TEST(DevelopWithGrain, GivesAnotherPatternForEachDirection) {
  const Curve outline = circle({0, 0}, {0.12, 0});
  const FabricLaw law = orthotropic(3000, 500, 40);
  // An ellipsoid, bust-like: its directions are not alike.
  const Surface bust = [](Vec2 p) {
    const Vec3 on_cap = cap(0.15)(p);
    return Vec3{on_cap.x, 1.4 * on_cap.y, 0.8 * on_cap.z};
  };
  const std::array<double, 3> angles{0, pi / 4, pi / 2};
  std::array<Flattened, 3> flats;
  std::array<FlatteningInput, 3> inputs;
  for (std::size_t i = 0; i < 3; ++i) {
    inputs[i] = region(outline, 0.01, bust, angles[i]);
    flats[i] = solve(inputs[i], law);
  }
  for (std::size_t own = 0; own < 3; ++own) {
    for (std::size_t other = 0; other < 3; ++other) {
      if (own == other) continue;
      // The other pattern cut at this grain: its places turned into this one's warp and weft.
      FlatteningInput borrowed = inputs[own];
      for (std::size_t p = 0; p < borrowed.start.size(); ++p) {
        borrowed.start[p] = test::turned(flats[other].uv[p], angles[other] - angles[own]);
      }
      const Flattened as_cut = flatten(borrowed, law, {.max_iterations = 0}, {});
      std::printf("grain: the pattern for %.0f deg cut at %.0f deg costs %.2f %% more\n", 180 / pi * angles[other],
                  180 / pi * angles[own], 100 * (total(as_cut) / total(flats[own]) - 1));
      EXPECT_GT(total(as_cut), 1.001 * total(flats[own])) << own << " " << other;
    }
  }
}

/// A stiff cloth hung by two of its corners: what is developed from the form that it takes is the cloth that was hung.
TEST(DevelopADrape, GivesBackItsOwnPattern) {
  const test::Sheet sheet = test::rectangle(0.2, 0.15, 16, 12);
  FabricSheet fabric;
  fabric.weight = 0.1;
  fabric.b = WarpWeft{1e-5, 1e-5};
  fabric.stretch = WarpWeft{2e5, 2e5};
  fabric.shear = 1e5;
  Placed start;
  for (std::size_t v = 0; v < sheet.points.size(); ++v) {
    const Vec2 p = sheet.points[v];
    start.positions.push_back({0.9 * p.x, 0.02 * std::sin(30 * p.x), p.y});
    if (p.y > 0.1499 && (p.x < 1e-9 || p.x > 0.1999)) start.held.push_back(static_cast<int>(v));
  }
  const Drape draped = drape(sheet.cloth, fabric, nullptr, start, {.accuracy = 1e-6}, {});
  ASSERT_TRUE(draped.converged) << draped.trouble;
  double strain = 0;
  for (std::size_t t = 0; t < draped.strain_warp.size(); ++t) {
    strain = std::max({strain, std::abs(draped.strain_warp[t]), std::abs(draped.strain_weft[t])});
  }
  EXPECT_LT(strain, 1e-4);
  FlatteningInput input;
  input.target = draped.positions;
  for (const ClothTriangle& triangle : sheet.cloth.triangles) input.triangles.push_back(triangle.vertices);
  for (const Vec2 p : sheet.points) input.start.push_back({1.2 * p.x, 0.8 * p.y});
  const int from = 16 + 1, to = 2 * 16 + 1;  // the ends of the second row, which lies along the warp
  input.grain = {{from, to}};
  const Flattened flat = solve(input, make_law(fabric));
  for (std::size_t v = 0; v < sheet.points.size(); ++v) {
    const Vec2 shift = sheet.points[static_cast<std::size_t>(from)] - flat.uv[static_cast<std::size_t>(from)];
    EXPECT_LT(distance(flat.uv[v] + shift, sheet.points[v]), 1e-3 * 0.25);
  }
}

}  // namespace
}  // namespace toile
