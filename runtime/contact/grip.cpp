#include "runtime/contact/grip.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double elastic_slip = 1e-4;  // [m] how far what sticks gives before it slips

/// Friction against slip, by the limit of its force: the force is 2 u - u^2 of the limit at u = slip / elastic_slip,
/// and the whole limit from 1 on, so that it is smooth where sticking ends (Li et al., Incremental Potential Contact,
/// SIGGRAPH 2020, 5.2).
double pull_per_slip(double slip) {
  const double u = slip / elastic_slip;
  return u < 1 ? (2 - u) / elastic_slip : 1 / slip;
}
double slip_at(double share) {
  return elastic_slip * (1 - std::sqrt(std::max(1 - share, 0.0)));
}

}  // namespace

Vector3 Grip::slip(const Vector3& at) const {
  const Vector3 away = at - anchor;
  return away - away.dot(normal) * normal;
}

double Grip::work(const Vector3& at) const {
  const double length = slip(at).norm(), u = length / elastic_slip;
  return limit * (u < 1 ? elastic_slip * u * u * (1 - u / 3) : length - elastic_slip / 3);
}

Vector3 Grip::pull(const Vector3& at) const {
  const Vector3 slid = slip(at);
  return limit * pull_per_slip(slid.norm()) * slid;
}

Matrix3 Grip::stiffness(const Vector3& at) const {
  const Vector3 slid = slip(at);
  const double length = slid.norm();
  const Matrix3 tangent = Matrix3::Identity() - normal * normal.transpose();
  // The pull grows less than in proportion, and past the cone not at all.
  const double loss = length < elastic_slip ? 1 / (elastic_slip * elastic_slip * std::max(length, 1e-12))
                                            : 1 / (length * length * length);
  return limit * pull_per_slip(length) * tangent - limit * loss * slid * slid.transpose();
}

Grip grip_on(const Vector3& pull, const Vector3& at, const Vector3& normal, double limit) {
  Grip grip{at, normal, limit};
  const Vector3 along = pull - pull.dot(normal) * normal;
  const double size = along.norm();
  if (size > 0) grip.anchor -= slip_at(size / limit) / size * along;
  return grip;
}

}  // namespace toile
