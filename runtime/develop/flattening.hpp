// Elongation and shear of one triangle whose place in space is given, as functions of its corners' places in the plane
// (paper, section 5): the membrane energy of runtime/energy with the parts of uv and x exchanged.
#pragma once

#include <array>
#include <optional>

#include "compiler/curve/vec2.hpp"
#include "runtime/energy/membrane.hpp"
#include "runtime/fabric/law.hpp"
#include "runtime/mesh/vec3.hpp"
#include "runtime/mesh/vector.hpp"

namespace toile {

/// A triangle in space, seen in its own plane: all that the energy asks of it.
struct TargetTriangle {
  Eigen::Matrix2d sides;  // [m] the first side lies along x; columns x1 - x0, x2 - x0
  double area = 0;        // [m2]
};
/// Nothing for a triangle without area.
std::optional<TargetTriangle> target_triangle(const std::array<Vec3, 3>& corners);

using PlaneCorners = std::array<Vec2, 3>;  // [m] (warp, weft)
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Twice the signed area.
inline double turn(const PlaneCorners& uv) {
  return cross(uv[1] - uv[0], uv[2] - uv[0]);
}

/// A triangle at a place in the plane, its corners counter-clockwise: E = A(uv) (psi_u + psi_v + psi_s) and its
/// derivatives by the six coordinates. As it shrinks to a line the energy grows without bound.
class FlatTriangle {
 public:
  FlatTriangle() = default;
  FlatTriangle(const FabricLaw& law, const TargetTriangle& target, const PlaneCorners& uv);

  MembraneEnergy energy() const { return {area_ * warp_.energy, area_ * weft_.energy, area_ * shear_.energy}; }
  double whole_energy() const { return area_ * density(); }
  Vector6 gradient() const;
  Matrix6 hessian(Curvature curvature) const;
  MembraneStrain strain() const;

 private:
  using Matrix4 = Eigen::Matrix4d;
  double density() const { return warp_.energy + weft_.energy + shear_.energy; }
  Matrix4 hessian_by_displacement() const;

  // Of F = X U^-1: the lengths of its columns fu and fv, fu . fv and fu x fv.
  double warp_length_ = 1, weft_length_ = 1, along_ = 0, across_ = 1;
  double area_ = 0;                        // in the plane
  std::array<double, 3> by_u_{}, by_v_{};  // [1/m] slopes of the corners' shape functions
  Density warp_, weft_, shear_;
};

}  // namespace toile
