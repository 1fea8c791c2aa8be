// The energy of one triangle by its corners in the plane, against finite differences.
#include "runtime/develop/flattening.hpp"

#include <gtest/gtest.h>

#include <random>

#include "runtime/develop/length_match.hpp"
#include "tests/support/flat_region.hpp"

namespace toile {
namespace {

using Eigen::Index;

FabricLaw wool() {
  FabricSheet sheet;
  sheet.lt = WarpWeft{0.8, 0.7};
  sheet.emt = WarpWeft{0.03, 0.06};
  sheet.g = WarpWeft{45, 45};
  sheet.hg = WarpWeft{1.5, 1.5};
  sheet.hg5 = WarpWeft{3, 3};
  return make_law(sheet);
}

struct Case {
  TargetTriangle target;
  PlaneCorners uv;
};

/// A triangle of some 10 mm and its place in the plane, strained by some `strain`.
Case random_case(std::mt19937& random, double strain) {
  std::uniform_real_distribution<double> any(-1, 1);
  for (;;) {
    PlaneCorners flat;
    for (Vec2& p : flat) p = {0.01 * any(random), 0.01 * any(random)};
    if (turn(flat) < 4e-5) continue;
    const double a = strain * any(random), b = strain * any(random), c = strain * any(random), d = strain * any(random);
    PlaneCorners uv;
    for (std::size_t i = 0; i < 3; ++i) {
      uv[i] = {(1 + a) * flat[i].x + b * flat[i].y + 0.3, c * flat[i].x + (1 + d) * flat[i].y - 0.2};
    }
    if (turn(uv) < 1e-5) continue;
    const auto space = [&](std::size_t i) { return Vec3{0.6 * flat[i].x, flat[i].y, 0.8 * flat[i].x}; };
    return {*target_triangle({space(0), space(1), space(2)}), uv};
  }
}

double sum(const MembraneEnergy& energy) {
  return energy.warp + energy.weft + energy.shear;
}

PlaneCorners moved(PlaneCorners uv, Index coordinate, double by) {
  Vec2& p = uv[static_cast<std::size_t>(coordinate / 2)];
  (coordinate % 2 == 0 ? p.x : p.y) += by;
  return uv;
}

class FlatteningOf : public testing::TestWithParam<double> {};

TEST_P(FlatteningOf, HasTheGradientAndHessianOfItsEnergy) {
  std::mt19937 random(7);
  const double h = 2e-9;
  for (const FabricLaw& law : {wool(), test::orthotropic(2000, 700, 60)}) {
    for (int round = 0; round < 40; ++round) {
      const Case c = random_case(random, GetParam());
      const FlatTriangle flat(law, c.target, c.uv);
      const Vector6 gradient = flat.gradient();
      const Matrix6 hessian = flat.hessian(Curvature::Full);
      for (Index i = 0; i < 6; ++i) {
        const FlatTriangle ahead(law, c.target, moved(c.uv, i, h)), behind(law, c.target, moved(c.uv, i, -h));
        const double more = sum(ahead.energy()), less = sum(behind.energy());
        EXPECT_NEAR((more - less) / (2 * h), gradient[i], 1e-5 * gradient.norm() + 1e-3 * h * hessian.norm());
        const Vector6 slope = (ahead.gradient() - behind.gradient()) / (2 * h);
        EXPECT_LT((slope - hessian.col(i)).norm(), 1e-4 * hessian.norm()) << slope << "\n\n" << hessian.col(i);
      }
    }
  }
}

TEST_P(FlatteningOf, HasADefinitePartThatIsTheWholeWhereThatIsDefinite) {
  std::mt19937 random(11);
  const FabricLaw law = wool();
  for (int round = 0; round < 40; ++round) {
    const Case c = random_case(random, GetParam());
    const Matrix6 part = FlatTriangle(law, c.target, c.uv).hessian(Curvature::PositiveDefinite);
    const Vector values = spectrum(part).values;
    EXPECT_GT(values[0], -1e-9 * values[5]);
    const Matrix6 whole = FlatTriangle(law, c.target, c.uv).hessian(Curvature::Full);
    if (GetParam() == 0) {
      EXPECT_LT((whole - part).norm(), 1e-9 * whole.norm());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(SmallAndLargeStrains, FlatteningOf, testing::Values(0.0, 0.01, 0.3));

TEST(Flattening, GivesTheStrainOfTheMembrane) {
  std::mt19937 random(3);
  const Case c = random_case(random, 0.1);
  const MembraneStrain strain = FlatTriangle(wool(), c.target, c.uv).strain();
  const auto corner = [&](double x, double y) { return Vector3(x, y, 0); };
  const Eigen::Matrix2d& sides = c.target.sides;
  const MembraneStrain same = membrane_strain(
      membrane_shape(c.uv), {corner(0, 0), corner(sides(0, 0), sides(1, 0)), corner(sides(0, 1), sides(1, 1))});
  EXPECT_NEAR(strain.warp, same.warp, 1e-12);
  EXPECT_NEAR(strain.weft, same.weft, 1e-12);
  EXPECT_NEAR(strain.shear, same.shear, 1e-12);
}

TEST(Flattening, CostsWithoutBoundAsATriangleShrinksToALine) {
  const TargetTriangle target = *target_triangle({Vec3{0, 0, 0}, Vec3{0.01, 0, 0}, Vec3{0, 0.01, 0}});
  double before = 0;
  for (const double height : {0.01, 1e-4, 1e-6, 1e-8}) {
    const PlaneCorners uv{Vec2{0, 0}, Vec2{0.01, 0}, Vec2{0.005, height}};
    const double energy = sum(FlatTriangle(wool(), target, uv).energy());
    EXPECT_GT(energy, 3 * before);
    before = energy;
  }
}

TEST(LengthMatch, HasTheDerivativesOfItsMismatch) {
  LengthMatch match{{0, 1}, {2, 3}, 0.002};
  std::array<Vec2, 4> points{Vec2{0, 0}, Vec2{0.01, 0.004}, Vec2{0.1, 0.02}, Vec2{0.107, 0.011}};
  const Mismatch found = mismatch(match, points);
  const double h = 1e-7;
  for (Index i = 0; i < 8; ++i) {
    const auto at = [&](double by) {
      std::array<Vec2, 4> all = points;
      Vec2& p = all[static_cast<std::size_t>(i / 2)];
      (i % 2 == 0 ? p.x : p.y) += by;
      return mismatch(match, all);
    };
    EXPECT_NEAR((at(h).value - at(-h).value) / (2 * h), found.gradient[i], 1e-7);
    const Vector8 slope = (at(h).gradient - at(-h).gradient) / (2 * h);
    EXPECT_LT((slope - found.hessian.col(i)).norm(), 1e-4 * found.hessian.norm());
  }
}

}  // namespace
}  // namespace toile
