// One interface for every term of the energy.
#pragma once

#include "runtime/mesh/vector.hpp"
#include "runtime/solve/sparse.hpp"

namespace toile {

/// A function of the unknowns q: 3 coordinates a vertex, then one rotation a hinge.
class Form {
 public:
  virtual ~Form() = default;
  /// The energy [J]; its derivative is added to `gradient` where given.
  virtual double energy(const Vector& q, Vector* gradient) const = 0;
  /// Adds second derivatives. The couplings must be among those the matrix was built for.
  virtual void add_hessian(const Vector& q, Curvature curvature, SparseMatrix& matrix) const = 0;
  /// How much of the step can be gone while the energy stays defined: in (0, 1].
  virtual double free_fraction(const Vector& /*q*/, const Vector& /*step*/) const { return 1; }
  /// The solver goes by `step` from q on; the second derivatives may use what a linear step foresees.
  virtual void foresee(const Vector& /*q*/, const Vector& /*step*/) {}
  /// The solver has come to rest at q for this step: history (unwrapped angles, anchors of friction) moves on.
  virtual void accept(const Vector& /*q*/) {}
};

}  // namespace toile
