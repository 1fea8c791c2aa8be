#include "runtime/energy/gravity.hpp"

#include <numeric>
#include <utility>

namespace toile {

GravityForm::GravityForm(std::vector<double> masses) : masses_(std::move(masses)) {}

double GravityForm::energy(const Vector& q, Vector* gradient) const {
  double energy = 0;
  for (std::size_t v = 0; v < masses_.size(); ++v) {
    const auto z = static_cast<Eigen::Index>(3 * v + 2);
    energy += standard_gravity * masses_[v] * q[z];
    if (gradient != nullptr) (*gradient)[z] += standard_gravity * masses_[v];
  }
  return energy;
}

double GravityForm::weight() const {
  return standard_gravity * std::accumulate(masses_.begin(), masses_.end(), 0.0);
}

}  // namespace toile
