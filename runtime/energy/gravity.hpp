// The weight of the cloth: E_g = g sum m_i z_i (paper, section 4), masses from the areas in the P-mesh.
#pragma once

#include <vector>

#include "runtime/solve/form.hpp"

namespace toile {

inline constexpr double standard_gravity = 9.80665;  // [m/s2]

class GravityForm : public Form {
 public:
  /// `masses`: of each vertex [kg].
  explicit GravityForm(std::vector<double> masses);
  double energy(const Vector& q, Vector* gradient) const override;
  void add_hessian(const Vector&, Curvature, SparseMatrix&) const override {}
  double weight() const;  // [N]

 private:
  std::vector<double> masses_;
};

}  // namespace toile
