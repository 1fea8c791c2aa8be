// The minimiser of the 1992 paper (section 4): a step of its own for every variable, that grows while the derivative is
// steady and shrinks when it changes. No line search, no matrix.
#pragma once

#include <functional>

#include "runtime/mesh/vector.hpp"

namespace toile {

struct OkabeOptions {
  int max_iterations = 100000;
  double first_step = 1e-3;  // in the variable's unit
  double longest_step = 1e-2;
  double grow = 1.2;    // while the derivative keeps its sign and size
  double shrink = 0.5;  // when it changes sign
  /// Asked after every iteration; true ends the run.
  std::function<bool(const Vector& gradient, const Vector& q, int iteration)> stop = {};
};

struct OkabeOutcome {
  bool stopped = false;  // by `stop`, rather than by the bound
  int iterations = 0;
};

/// `function` returns the value and fills the gradient. Variables whose derivative is zero stay.
OkabeOutcome okabe(const std::function<double(const Vector& q, Vector& gradient)>& function,
                   const OkabeOptions& options, Vector& q);

}  // namespace toile
