// Newton's method for a static equilibrium, kept on its way by a proximal term that vanishes as it gets there.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/solve/form.hpp"
#include "runtime/solve/job.hpp"
#include "runtime/solve/sparse.hpp"

namespace toile {

struct NewtonProblem {
  std::vector<Form*> forms;
  SparseMatrix* matrix = nullptr;  // with the pattern of all forms
  Cholesky* cholesky = nullptr;    // analysed for it
  std::vector<double> inertia;     // of each unknown; the proximal term is inertia * rate [kg]
  int coordinates = 0;             // the first so many unknowns are positions [m]
  std::function<double(const Vector& gradient, const Vector& q)>
      residual;  // relative; the gradient at held unknowns is zero
  /// Called before the matrix is filled at q: gives it (and the analysis) places for what the forms now couple.
  std::function<void(const Vector& q)> fit = {};
  /// Whether it will never come to rest.
  std::function<bool(const Vector& q)> is_lost = {};
};

struct NewtonOptions {
  double tolerance = 1e-3;  // of the relative residual
  int max_iterations = 1000;
  double rate = 1e3;           // [1/s2] to start with: an implicit step of 1/sqrt(rate) seconds
  double longest_step = 0.03;  // [m] of a vertex in one iteration
};

struct NewtonOutcome {
  bool converged = false;
  bool cancelled = false;
  int iterations = 0;
  double residual = 0;
  double rate = 0;  // the proximal rate at the end
};

/// Minimises the sum of the forms from q on. q is finite at every return.
NewtonOutcome newton(const NewtonProblem& problem, const NewtonOptions& options, const Job& job, Vector& q);

}  // namespace toile
