// Layers of cloth: their distances, the energy that keeps them apart, the way they are free to go, and the way out of
// crossings.
#include "runtime/contact/self_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "runtime/contact/advance.hpp"
#include "runtime/contact/self_intersections.hpp"
#include "runtime/contact/untangle.hpp"
#include "tests/support/sheet.hpp"

namespace toile {
namespace {

constexpr double gap = 1e-3;         // [m]
constexpr double pressure = 5000.0;  // [Pa]

class Scatter {
 public:
  double in(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Vector3 vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Quad quad(double size) { return {vector(size), vector(size), vector(size), vector(size)}; }

 private:
  std::mt19937 engine_{11};
};

Vector stacked(const Quad& x) {
  Vector12 q;
  q << x[0], x[1], x[2], x[3];
  return q;
}

Quad unstacked(const Vector& q) {
  return {q.segment<3>(0), q.segment<3>(3), q.segment<3>(6), q.segment<3>(9)};
}

/// The least squared distance over a fine net of places on both primitives.
double sampled(Pair::Kind kind, const Quad& x) {
  constexpr int n = 60;
  double least = 1e9;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= (kind == Pair::Kind::CornerTriangle ? n - i : n); ++j) {
      const double s = 1.0 * i / n, t = 1.0 * j / n;
      const Vector3 apart = kind == Pair::Kind::CornerTriangle
                                ? Vector3(x[0] - (1 - s - t) * x[1] - s * x[2] - t * x[3])
                                : Vector3((1 - s) * x[0] + s * x[1] - (1 - t) * x[2] - t * x[3]);
      least = std::min(least, apart.squaredNorm());
    }
  }
  return least;
}

/// Two triangles of 2 cm, the second `height` above the first and turned by `turn`.
struct TwoTriangles {
  Cloth cloth;
  Vector q;
};
TwoTriangles two_triangles(double height, double turn) {
  const double side = 0.02;
  TwoTriangles two{
      test::cloth_of({{0, 0}, {side, 0}, {0, side}, {0.1, 0}, {0.1 + side, 0}, {0.1, side}}, {{0, 1, 2}, {3, 4, 5}}),
      Vector::Zero(18)};
  const double c = std::cos(turn), s = std::sin(turn);
  two.q << 0, 0, 0, side, 0, 0, 0, side, 0,  //
      0.004, 0.003, height, 0.004 + side * c, 0.003 + side * s, height, 0.004 - side * s, 0.003 + side * c,
      1.3 * height;
  return two;
}

TEST(Proximity, IsTheLeastDistanceOfAllPlaces) {
  Scatter random;
  for (int trial = 0; trial < 200; ++trial) {
    const Quad x = random.quad(1);
    for (const auto kind : {Pair::Kind::CornerTriangle, Pair::Kind::EdgeEdge}) {
      const double found = std::sqrt(proximity(kind, x).squared), net = std::sqrt(sampled(kind, x));
      EXPECT_LE(found, net + 1e-12);
      EXPECT_GE(found, net - 0.06) << "the net's places are that near to any other";
    }
  }
}

TEST(Proximity, DerivativesOfTheSquareAreThoseOfDifferences) {
  Scatter random;
  for (int trial = 0; trial < 100; ++trial) {
    const Quad x = random.quad(1);
    for (const auto kind : {Pair::Kind::CornerTriangle, Pair::Kind::EdgeEdge}) {
      const Proximity near = proximity(kind, x);
      const Vector12 gradient = squared_gradient(near, x);
      const Matrix12 hessian = squared_hessian(near, x);
      const double h = 1e-6;
      for (int i = 0; i < 12; ++i) {
        Vector forth = stacked(x), back = stacked(x);
        forth[i] += h;
        back[i] -= h;
        const Quad y = unstacked(forth), z = unstacked(back);
        const Proximity at_y = proximity(kind, y), at_z = proximity(kind, z);
        EXPECT_NEAR(gradient[i], (at_y.squared - at_z.squared) / (2 * h), 1e-7);
        if (at_y.freedoms != at_z.freedoms) continue;  // the second derivative jumps from face to side to corner
        const Vector12 column = (squared_gradient(at_y, y) - squared_gradient(at_z, z)) / (2 * h);
        EXPECT_LT((hessian.col(i) - column).norm(), 1e-3 * std::max(1.0, column.norm()));
      }
    }
  }
}

TEST(FreeFraction, LeavesATenthOfTheDistanceAndNeverStopsWithoutNeed) {
  Scatter random;
  int stopped = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Pair pair{trial % 2 == 0 ? Pair::Kind::CornerTriangle : Pair::Kind::EdgeEdge, 0, 0, {0, 1, 2, 3}};
    const Vector q = stacked(random.quad(1)), step = stacked(random.quad(1.5));
    const double free = free_fraction(pair, q, step, 1);
    ASSERT_GT(free, 0);
    const double start = std::sqrt(proximity(pair.kind, unstacked(q)).squared);
    double least = start;
    for (int i = 0; i <= 200; ++i) {
      least = std::min(least, std::sqrt(proximity(pair.kind, unstacked(q + free * i / 200 * step)).squared));
    }
    EXPECT_GE(least, 0.0999 * start);
    if (free == 1) continue;
    ++stopped;
    EXPECT_LT(least, 0.12 * start) << "stopped, though not near";
  }
  EXPECT_GT(stopped, 20);
}

TEST(SelfContact, DerivativesAreThoseOfDifferences) {
  // Turned: edges cross; hardly turned: they are near to parallel, where their share rises from nothing.
  for (const double turn : {0.5, 0.05, 0.02}) {
    TwoTriangles two = two_triangles(0.4 * gap, turn);
    const SelfContact contact(two.cloth, gap, pressure);
    Vector gradient = Vector::Zero(18);
    ASSERT_GT(contact.energy(two.q, &gradient), 0);
    std::vector<int> reduced(18);
    for (int i = 0; i < 18; ++i) reduced[static_cast<std::size_t>(i)] = i;
    SparseMatrix matrix(reduced, contact.couplings(two.q));
    ASSERT_TRUE(contact.fits(two.q, matrix));
    contact.add_hessian(two.q, Curvature::Full, matrix);
    const double h = 1e-8;
    for (int i = 0; i < 18; ++i) {
      Vector forth = two.q, back = two.q, up = Vector::Zero(18), down = Vector::Zero(18);
      forth[i] += h;
      back[i] -= h;
      const double slope = (contact.energy(forth, &up) - contact.energy(back, &down)) / (2 * h);
      EXPECT_NEAR(gradient[i], slope, 1e-5 * gradient.norm()) << turn;
      const Vector column = (up - down) / (2 * h);
      for (int j = i; j < 18; ++j) {
        if (!matrix.has(j, i)) continue;
        const int place = matrix.places({i, j})[1];
        EXPECT_NEAR(matrix.values()[static_cast<std::size_t>(place)], column[j], 2e-4 * column.norm() + 1e-6) << turn;
      }
    }
  }
}

/// Two triangles that rub, the upper one drawn along the lower by `slip` since the solver's latest rest.
struct Rubbing {
  TwoTriangles two = two_triangles(0.4 * gap, 0.5);
  SelfContact contact{two.cloth, gap, pressure};
  Rubbing(double slip, double friction) {
    contact.set_friction({friction});
    contact.accept(two.q);
    for (int v = 3; v < 6; ++v) two.q[3 * v] += slip;
  }
  /// What the upper triangle is drawn with [N].
  Vector3 pull() const {
    Vector gradient = Vector::Zero(18);
    contact.energy(two.q, &gradient);
    Vector3 sum = Vector3::Zero();
    for (int v = 3; v < 6; ++v) sum -= gradient.segment<3>(3 * v);
    return sum;
  }
};

TEST(SelfContact, DerivativesOfFrictionAreThoseOfDifferences) {
  for (const double slip : {2e-5, 3e-4}) {
    Rubbing rubbing(slip, 0.4);
    std::vector<int> reduced(18);
    for (int i = 0; i < 18; ++i) reduced[static_cast<std::size_t>(i)] = i;
    SelfContact smooth(rubbing.two.cloth, gap, pressure);
    const auto of_friction = [&](const Vector& q) {
      Vector rubs = Vector::Zero(18), slides = Vector::Zero(18);
      rubbing.contact.energy(q, &rubs);
      smooth.energy(q, &slides);
      return Vector(rubs - slides);
    };
    SparseMatrix rubs(reduced, rubbing.contact.couplings(rubbing.two.q)), slides = rubs;
    rubbing.contact.add_hessian(rubbing.two.q, Curvature::Full, rubs);
    smooth.add_hessian(rubbing.two.q, Curvature::Full, slides);
    const Vector gradient = of_friction(rubbing.two.q);
    ASSERT_GT(gradient.norm(), 0);
    for (int i = 0; i < 18; ++i) {
      const double h = 1e-9;
      Vector forth = rubbing.two.q, back = rubbing.two.q;
      forth[i] += h;
      back[i] -= h;
      const double slope = (rubbing.contact.friction_energy(forth) - rubbing.contact.friction_energy(back)) / (2 * h);
      EXPECT_NEAR(gradient[i], slope, 1e-5 * gradient.norm()) << slip;
      const Vector column = (of_friction(forth) - of_friction(back)) / (2 * h);
      for (int j = i; j < 18; ++j) {
        if (!rubs.has(j, i)) continue;
        const auto place = static_cast<std::size_t>(rubs.places({i, j})[1]);
        EXPECT_NEAR(rubs.values()[place] - slides.values()[place], column[j], 1e-3 * column.norm() + 1e-3) << slip;
      }
    }
  }
}

TEST(SelfContact, RubsByTheCoefficientTimesWhatPresses) {
  // Apart from the barrier's own small slope along x, which the two with and without friction share.
  const Rubbing slips(2e-4, 0.4), smooth(2e-4, 0), hardly(1e-5, 0.4), hardly_smooth(1e-5, 0);
  const double presses = Rubbing(0, 0).pull().z();
  EXPECT_NEAR((slips.pull() - smooth.pull()).x(), -0.4 * presses, 0.02 * presses);
  const double holds = -(hardly.pull() - hardly_smooth.pull()).x();
  EXPECT_GT(holds, 0);
  EXPECT_LT(holds, 0.4 * 0.2 * presses);
}

TEST(SelfContact, PushesLayersApartWithOpposedForcesAndOnlyWithinTheGap) {
  TwoTriangles near = two_triangles(0.5 * gap, 0.5);
  Vector gradient = Vector::Zero(18);
  SelfContact(near.cloth, gap, pressure).energy(near.q, &gradient);
  double lower = 0, upper = 0;
  for (int v = 0; v < 3; ++v) {
    lower -= gradient[3 * v + 2];
    upper -= gradient[9 + 3 * v + 2];
  }
  EXPECT_LT(lower, 0);
  EXPECT_NEAR(lower, -upper, 1e-12 * std::abs(upper));
  TwoTriangles far = two_triangles(1.01 * gap, 0.5);
  EXPECT_EQ(SelfContact(far.cloth, gap, pressure).energy(far.q, nullptr), 0);
}

TEST(SelfContact, AStepThroughTheOtherLayerIsCutBeforeIt) {
  TwoTriangles two = two_triangles(5e-3, 0.5);
  Vector step = Vector::Zero(18);
  for (int v = 3; v < 6; ++v) step[3 * v + 2] = -0.02;
  const SelfContact contact(two.cloth, gap, pressure);
  const double free = contact.free_fraction(two.q, step);
  EXPECT_GT(free, 0.2);
  EXPECT_LT(free, 0.25);
  EXPECT_TRUE(std::isfinite(contact.energy(two.q + free * step, nullptr)));
}

TEST(Untangle, PullsAStripOutOfTheSheetThatItPierces) {
  // A corner of the upper triangle hangs through the lower one.
  TwoTriangles two = two_triangles(2e-3, 0.5);
  two.q[9 + 2] = -1e-3;
  ASSERT_GT(crossings(two.cloth, two.q).pairs, 0);
  const int left = untangle(
      two.cloth, [](const Vector& force) { return force; }, 5e-4, {}, two.q);
  EXPECT_EQ(left, 0);
  EXPECT_EQ(crossings(two.cloth, two.q).pairs, 0);
}

TEST(Untangle, TheGradientIsThatOfTheLengthOfTheCrossing) {
  TwoTriangles two = two_triangles(2e-3, 0.5);
  two.q[9 + 2] = -1e-3;
  const Crossings at = crossings(two.cloth, two.q);
  ASSERT_GT(at.length, 0);
  for (int i = 0; i < 18; ++i) {
    Vector forth = two.q, back = two.q;
    forth[i] += 1e-7;
    back[i] -= 1e-7;
    const double slope = (crossings(two.cloth, forth).length - crossings(two.cloth, back).length) / 2e-7;
    EXPECT_NEAR(at.gradient[i], slope, 1e-4);
  }
}

}  // namespace
}  // namespace toile
