// The paper's minimiser on the functions that minimisers are classically tried on.
#include "runtime/solve/okabe.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace toile {
namespace {

using Function = std::function<double(const Vector&)>;

/// Minimises with derivatives by central differences and returns the value reached.
double minimum(const Function& f, Vector x) {
  const auto with_gradient = [&](const Vector& q, Vector& gradient) {
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      Vector up = q, down = q;
      up[i] += 1e-6;
      down[i] -= 1e-6;
      gradient[i] = (f(up) - f(down)) / 2e-6;
    }
    return f(q);
  };
  OkabeOptions options{.max_iterations = 200000, .first_step = 1e-2, .longest_step = 0.1};
  options.stop = [&](const Vector& gradient, const Vector&, int) { return gradient.norm() < 1e-7; };
  okabe(with_gradient, options, x);
  return f(x);
}

double square(double a) {
  return a * a;
}

TEST(Okabe, FindsTheMinimumOfRosenbrock) {
  EXPECT_LT(minimum([](const Vector& x) { return 100 * square(x[1] - x[0] * x[0]) + square(1 - x[0]); },
                    Eigen::Vector2d(-1.2, 1)),
            1e-8);
}

TEST(Okabe, FindsTheMinimumOfPowellsSingularFunction) {
  const auto powell = [](const Vector& x) {
    return square(x[0] + 10 * x[1]) + 5 * square(x[2] - x[3]) + square(square(x[1] - 2 * x[2])) +
           10 * square(square(x[0] - x[3]));
  };
  EXPECT_LT(minimum(powell, Eigen::Vector4d(3, -1, 0, 1)), 1e-6);
}

TEST(Okabe, FindsTheMinimumOfWood) {
  const auto wood = [](const Vector& x) {
    return 100 * square(x[1] - x[0] * x[0]) + square(1 - x[0]) + 90 * square(x[3] - x[2] * x[2]) + square(1 - x[2]) +
           10.1 * (square(x[1] - 1) + square(x[3] - 1)) + 19.8 * (x[1] - 1) * (x[3] - 1);
  };
  EXPECT_LT(minimum(wood, Eigen::Vector4d(-3, -1, -3, -1)), 1e-8);
}

TEST(Okabe, FindsTheMinimumOfBeale) {
  const auto beale = [](const Vector& x) {
    return square(1.5 - x[0] * (1 - x[1])) + square(2.25 - x[0] * (1 - square(x[1]))) +
           square(2.625 - x[0] * (1 - std::pow(x[1], 3)));
  };
  EXPECT_LT(minimum(beale, Eigen::Vector2d(1, 1)), 1e-8);
}

TEST(Okabe, FindsTheMinimumOfTheHelicalValley) {
  const auto helical = [](const Vector& x) {
    const double turn = std::atan2(x[1], x[0]) / (2 * M_PI);
    return 100 * square(x[2] - 10 * turn) + 100 * square(std::hypot(x[0], x[1]) - 1) + square(x[2]);
  };
  EXPECT_LT(minimum(helical, Eigen::Vector3d(-1, 0, 0)), 1e-8);
}

}  // namespace
}  // namespace toile
