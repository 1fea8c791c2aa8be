// Coulomb friction that truly sticks: a tangential spring from an anchor, which slips where it reaches the cone.
#pragma once

#include "runtime/mesh/vector.hpp"

namespace toile {

/// What friction has hold of between two steps of the solver: a place on a body, or where two layers of cloth lie on
/// each other, the way from the one to the other.
struct Grip {
  Vector3 anchor = Vector3::Zero();
  Vector3 normal = Vector3::Zero();
  double limit = 0;  // [N] coefficient times normal force

  /// The way from the anchor that counts: along the surface.
  Vector3 slip(const Vector3& at) const;
  /// The energy [J] there, its gradient [N] and its second derivative [N/m], which is never negative.
  double work(const Vector3& at) const;
  Vector3 pull(const Vector3& at) const;
  Matrix3 stiffness(const Vector3& at) const;
};

/// Takes hold at that place such that `pull` goes on as it was, turned into the plane of the new normal and cut at the
/// new limit: a change of the normal force alone moves nothing that sticks.
Grip grip_on(const Vector3& pull, const Vector3& at, const Vector3& normal, double limit);

}  // namespace toile
