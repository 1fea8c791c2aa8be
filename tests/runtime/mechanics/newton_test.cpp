// Newton's method where contact leaves it little room.
#include "runtime/solve/newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double spring = 100;    // [N/m]
constexpr double repulsion = 1;   // [J]
constexpr double pressing = 1e3;  // [N]

/// A point that a spring draws along a wall, with a barrier between the two; it may go by a few times its distance.
class AlongAWall : public Form {
 public:
  double energy(const Vector& q, Vector* gradient) const override {
    if (gradient != nullptr) {
      (*gradient)[0] += spring * (q[0] - 1);
      (*gradient)[1] += pressing - repulsion / q[1];
      (*gradient)[2] += spring * q[2];
    }
    return spring / 2 * ((q[0] - 1) * (q[0] - 1) + q[2] * q[2]) + pressing * q[1] - repulsion * std::log(q[1]);
  }
  void add_hessian(const Vector& q, Curvature, SparseMatrix& matrix) const override {
    matrix.add(0, 0, spring);
    matrix.add(1, 1, repulsion / (q[1] * q[1]));
    matrix.add(2, 2, spring);
  }
  double free_fraction(const Vector& q, const Vector& step) const override {
    return std::min(1.0, 5 * q[1] / std::max(step.norm(), 1e-300)) * (q[1] + step[1] > 0 ? 1 : 0.1);
  }
};

TEST(NewtonTest, WhatAllButTouchesComesApart) {
  AlongAWall form;
  SparseMatrix matrix({0, 1, 2}, {{0, 1, 2}});
  Cholesky cholesky;
  cholesky.analyse(matrix);
  Vector q(3);
  q << 0, 1e-7, 0;
  const NewtonProblem problem{
      {&form}, &matrix, &cholesky, {1, 1, 1}, 3, [](const Vector& gradient, const Vector&) { return gradient.norm(); }};
  const NewtonOutcome outcome = newton(problem, {.tolerance = 1e-6, .max_iterations = 300}, {}, q);
  EXPECT_TRUE(outcome.converged) << outcome.iterations << " iterations, residual " << outcome.residual;
  EXPECT_NEAR(q[0], 1, 1e-6);
  EXPECT_NEAR(q[1], repulsion / pressing, 1e-6);
}

}  // namespace
}  // namespace toile
