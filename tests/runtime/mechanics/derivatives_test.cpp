// Every term's gradient and Hessian against central differences of its energy and gradient.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "runtime/energy/bending.hpp"
#include "runtime/energy/dihedral.hpp"
#include "runtime/energy/elastic.hpp"
#include "runtime/energy/membrane.hpp"
#include "tests/support/sheet.hpp"

namespace toile {
namespace {

using test::rectangle;

/// Central difference with Richardson extrapolation.
double derivative(const std::function<double(double)>& f, double step) {
  const auto central = [&](double h) { return (f(h) - f(-h)) / (2 * h); };
  return (4 * central(step / 2) - central(step)) / 3;
}

FabricSheet wool() {
  FabricSheet sheet;
  sheet.emt = WarpWeft{0.045, 0.06};
  sheet.lt = WarpWeft{0.6, 0.65};
  sheet.g = WarpWeft{33.7, 33.7};
  sheet.hg = WarpWeft{0.6, 0.6};
  sheet.hg5 = WarpWeft{1.4, 1.4};
  sheet.b = WarpWeft{7e-6, 5e-6};
  sheet.hb = WarpWeft{2e-4, 1.5e-4};
  sheet.weight = 0.19;
  return sheet;
}

void expect_law_is_consistent(const std::function<Density(double)>& law, double at, double step) {
  const double force = derivative([&](double h) { return law(at + h).energy; }, step);
  const double stiffness = derivative([&](double h) { return law(at + h).force; }, step);
  EXPECT_NEAR(law(at).force, force, 1e-6 * (1 + std::abs(force))) << "at " << at;
  EXPECT_NEAR(law(at).stiffness, stiffness, 1e-5 * (1 + std::abs(stiffness))) << "at " << at;
}

TEST(Laws, ForceAndStiffnessAreDerivativesOfTheEnergy) {
  const FabricLaw law = make_law(wool());
  for (const double strain : {-0.2, -0.01, -5e-5, 3e-5, 0.002, 0.03, 0.08}) {
    expect_law_is_consistent(law.warp, strain, 1e-6);
  }
  for (const double angle : {-0.6, -0.145, -0.05, -0.002, 0.001, 0.01, 0.15, 0.3, 0.9}) {
    expect_law_is_consistent(law.shear, angle, 1e-5);
  }
  for (const double curvature : {-200.0, -3.0, 0.0, 1.0, 40.0}) {
    const auto bend = [&](double k) { return law.bend_warp(k); };
    const double force = derivative([&](double h) { return bend(curvature + h).energy; }, 1e-2);
    EXPECT_NEAR(bend(curvature).force, force, 1e-9);
  }
}

TEST(Laws, ElongationReadsTheSheetBack) {
  const ElongationLaw law = ElongationLaw::from_kes(0.045, 0.6);
  EXPECT_NEAR(law(0.045).force, 490.33, 0.1);
  EXPECT_NEAR(law(0.045).energy, 0.6 * 490.33 * 0.045 / 2, 0.01);
}

struct Random {
  std::mt19937 engine{42};
  double operator()() { return static_cast<double>(engine() % 200001) / 100000.0 - 1; }
  Vector3 vector(double scale) { return scale * Vector3((*this)(), (*this)(), (*this)()); }
};

TEST(Membrane, GradientAndHessianMatchDifferences) {
  const FabricLaw law = make_law(wool());
  Random random;
  for (int round = 0; round < 20; ++round) {
    const MembraneShape shape = membrane_shape({Vec2{0, 0}, Vec2{0.011, 0.002}, Vec2{0.003, 0.009}});
    Corners x{Vector3(0, 0, 0) + random.vector(5e-4), Vector3(0.011, 0.002, 0) + random.vector(1e-3),
              Vector3(0.003, 0.009, 0) + random.vector(1e-3)};
    Vector9 gradient;
    membrane_energy(law, shape, x, &gradient);
    const Matrix9 hessian = membrane_hessian(law, shape, x, membrane_strain(shape, x), Curvature::Full);
    const double stiff = hessian.cwiseAbs().maxCoeff(), force = gradient.cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < 9; ++i) {
      const auto moved = [&](double h) {
        Corners y = x;
        y[i / 3][static_cast<Eigen::Index>(i % 3)] += h;
        return y;
      };
      const double slope = derivative(
          [&](double h) {
            const MembraneEnergy e = membrane_energy(law, shape, moved(h), nullptr);
            return e.warp + e.weft + e.shear;
          },
          1e-7);
      EXPECT_NEAR(gradient[static_cast<Eigen::Index>(i)], slope, 1e-6 * force);
      for (std::size_t j = 0; j < 9; ++j) {
        const double curve = derivative(
            [&](double h) {
              Vector9 g;
              membrane_energy(law, shape, moved(h), &g);
              return g[static_cast<Eigen::Index>(j)];
            },
            1e-7);
        EXPECT_NEAR(hessian(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)), curve, 1e-6 * stiff);
      }
    }
    const Matrix9 definite = membrane_hessian(law, shape, x, membrane_strain(shape, x), Curvature::PositiveDefinite);
    EXPECT_GT(spectrum(definite).values.minCoeff(), -1e-9 * stiff);
  }
}

TEST(Membrane, ForeseenStrainIsLinearInTheStep) {
  Random random;
  const MembraneShape shape = membrane_shape({Vec2{0, 0}, Vec2{0.011, 0.002}, Vec2{0.003, 0.009}});
  const Corners x{Vector3(0, 0, 0) + random.vector(1e-3), Vector3(0.011, 0.002, 0) + random.vector(1e-3),
                  Vector3(0.003, 0.009, 0) + random.vector(1e-3)};
  const Corners step{random.vector(1e-3), random.vector(1e-3), random.vector(1e-3)};
  const MembraneStrain now = membrane_strain(shape, x), foreseen = foreseen_strain(shape, x, step);
  const auto along = [&](double h) {
    return membrane_strain(shape, {x[0] + h * step[0], x[1] + h * step[1], x[2] + h * step[2]});
  };
  EXPECT_NEAR(foreseen.warp - now.warp, derivative([&](double h) { return along(h).warp; }, 1e-4), 1e-8);
  EXPECT_NEAR(foreseen.weft - now.weft, derivative([&](double h) { return along(h).weft; }, 1e-4), 1e-8);
  EXPECT_NEAR(foreseen.shear - now.shear, derivative([&](double h) { return along(h).shear; }, 1e-4), 1e-8);
}

TEST(Dihedral, GradientAndHessianMatchDifferences) {
  Random random;
  for (int round = 0; round < 20; ++round) {
    Hinge x{Vector3(0, 0, 0) + random.vector(0.2), Vector3(1, 0, 0) + random.vector(0.2),
            Vector3(0.4, 0.9, 0) + random.vector(0.5), Vector3(0.6, -0.8, 0) + random.vector(0.5)};
    const Vector12 gradient = dihedral_gradient(x);
    const Matrix12 hessian = dihedral_hessian(x);
    for (std::size_t i = 0; i < 12; ++i) {
      const auto moved = [&](double h) {
        Hinge y = x;
        y[i / 3][static_cast<Eigen::Index>(i % 3)] += h;
        return y;
      };
      EXPECT_NEAR(gradient[static_cast<Eigen::Index>(i)],
                  derivative([&](double h) { return dihedral(moved(h)); }, 1e-4), 1e-6);
      for (std::size_t j = 0; j < 12; ++j) {
        const double curve =
            derivative([&](double h) { return dihedral_gradient(moved(h))[static_cast<Eigen::Index>(j)]; }, 1e-4);
        EXPECT_NEAR(hessian(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)), curve, 1e-5);
      }
    }
  }
}

/// A crumpled sheet of 3 x 2 cells with its unknowns.
struct Crumpled {
  test::Sheet sheet = rectangle(0.03, 0.02, 3, 2);
  ElasticForm form{sheet.cloth, make_law(wool())};
  Vector q = Vector::Zero(form.unknowns().count());

  Crumpled() {
    Random random;
    for (std::size_t v = 0; v < sheet.points.size(); ++v) {
      q.segment<3>(static_cast<Eigen::Index>(3 * v)) =
          Vector3(sheet.points[v].x, sheet.points[v].y, 0) + random.vector(2e-3);
    }
    for (int h = 0; h < form.unknowns().hinges; ++h) q[form.unknowns().rotation(h)] = 0.2 * random();
  }
};

TEST(Elastic, GradientOfTheWholeClothMatchesDifferences) {
  const Crumpled c;
  Vector gradient = Vector::Zero(c.q.size());
  c.form.energy(c.q, &gradient);
  for (Eigen::Index i = 0; i < c.q.size(); ++i) {
    const double step = i < 3 * c.form.unknowns().vertices ? 1e-7 : 1e-4;
    const double slope = derivative(
        [&](double h) {
          Vector moved = c.q;
          moved[i] += h;
          return c.form.energy(moved, nullptr);
        },
        step);
    EXPECT_NEAR(gradient[i], slope, 1e-6 * gradient.cwiseAbs().maxCoeff());
  }
}

TEST(Elastic, HessianOfTheWholeClothMatchesDifferences) {
  Crumpled c;
  std::vector<int> reduced(static_cast<std::size_t>(c.q.size()));
  for (std::size_t i = 0; i < reduced.size(); ++i) reduced[i] = static_cast<int>(i);
  SparseMatrix matrix(reduced, c.form.couplings());
  c.form.prepare(matrix);
  c.form.add_hessian(c.q, Curvature::Full, matrix);
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(c.q.size(), c.q.size());
  for (int column = 0; column < matrix.rows(); ++column) {
    const auto at = static_cast<std::size_t>(column);
    for (int k = matrix.column_start()[at]; k < matrix.column_start()[at + 1]; ++k) {
      const auto entry = static_cast<std::size_t>(k);
      hessian(matrix.row_index()[entry], column) = hessian(column, matrix.row_index()[entry]) = matrix.values()[entry];
    }
  }
  // Scale by the diagonal: coordinates and rotations have different units.
  for (Eigen::Index i = 0; i < c.q.size(); ++i) {
    const double step = i < 3 * c.form.unknowns().vertices ? 1e-7 : 1e-5;
    for (Eigen::Index j = 0; j < c.q.size(); ++j) {
      const double curve = derivative(
          [&](double h) {
            Vector moved = c.q, gradient = Vector::Zero(c.q.size());
            moved[i] += h;
            c.form.energy(moved, &gradient);
            return gradient[j];
          },
          step);
      const double scale = std::sqrt(std::abs(hessian(i, i) * hessian(j, j)));
      EXPECT_NEAR(hessian(j, i), curve, 1e-5 * scale + 1e-12) << i << ", " << j;
    }
  }
}

TEST(Elastic, GradientFollowsThePatternAsDifferencesDo) {
  const Crumpled c;
  const std::vector<PatternCoupling> couplings = c.form.pattern_couplings(c.sheet.cloth, c.q);
  const auto gradient_with = [&](std::size_t t, std::size_t corner, Vec2 change) {
    Cloth cloth = c.sheet.cloth;
    cloth.triangles[t].uv[corner] = cloth.triangles[t].uv[corner] + change;
    Vector gradient = Vector::Zero(c.q.size());
    ElasticForm(cloth, make_law(wool())).energy(c.q, &gradient);
    return gradient;
  };
  for (const std::size_t t : {std::size_t{0}, std::size_t{5}, c.sheet.cloth.triangles.size() - 1}) {
    const double scale = couplings[t].by_corners.cwiseAbs().maxCoeff();
    for (int column = 0; column < 6; ++column) {
      Vector by_pattern = Vector::Zero(c.q.size());
      for (std::size_t k = 0; k < couplings[t].unknowns.size(); ++k) {
        by_pattern[couplings[t].unknowns[k]] += couplings[t].by_corners(static_cast<Eigen::Index>(k), column);
      }
      for (Eigen::Index i = 0; i < c.q.size(); ++i) {
        const double slope = derivative(
            [&](double h) {
              return gradient_with(t, static_cast<std::size_t>(column / 2),
                                   column % 2 == 0 ? Vec2{h, 0} : Vec2{0, h})[i];
            },
            1e-7);
        EXPECT_NEAR(by_pattern[i], slope, 1e-6 * scale) << t << ", " << column << ", " << i;
      }
    }
  }
}

TEST(Elastic, RigidMotionOfAFlatSheetCostsNothing) {
  const test::Sheet sheet = rectangle(0.1, 0.06, 7, 5);
  const ElasticForm form(sheet.cloth, make_law(wool()));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  Vector q = Vector::Zero(form.unknowns().count()), gradient = q;
  for (std::size_t v = 0; v < sheet.points.size(); ++v) {
    q.segment<3>(static_cast<Eigen::Index>(3 * v)) =
        turn * Vector3(sheet.points[v].x, sheet.points[v].y, 0) + Vector3(0.3, 0.2, -1);
  }
  EXPECT_NEAR(form.energy(q, &gradient), 0, 1e-12);
  EXPECT_LT(gradient.cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace toile
