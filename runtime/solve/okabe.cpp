#include "runtime/solve/okabe.hpp"

#include <algorithm>
#include <cmath>

namespace toile {

OkabeOutcome okabe(const std::function<double(const Vector& q, Vector& gradient)>& function,
                   const OkabeOptions& options, Vector& q) {
  Vector step = Vector::Constant(q.size(), options.first_step);
  Vector gradient = Vector::Zero(q.size()), last = Vector::Zero(q.size());
  OkabeOutcome outcome;
  function(q, gradient);
  for (; outcome.iterations < options.max_iterations; ++outcome.iterations) {
    if (options.stop && options.stop(gradient, q, outcome.iterations)) {
      outcome.stopped = true;
      break;
    }
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      const double change = gradient[i] * last[i];
      if (change < 0) {
        step[i] *= options.shrink;
      } else if (change > 0.25 * last[i] * last[i]) {
        step[i] = std::min(step[i] * options.grow, options.longest_step);
      }
      if (gradient[i] != 0) q[i] -= std::copysign(step[i], gradient[i]);
    }
    last = gradient;
    function(q, gradient);
  }
  return outcome;
}

}  // namespace toile
