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

MembraneStrain flattening_strain(const TargetTriangle& target, const PlaneCorners& uv);

/// E = A(uv) (psi_u + psi_v + psi_s) and its gradient by the six coordinates where given. The corners must lie counter-
/// clockwise; as the triangle shrinks to a line the energy grows without bound.
MembraneEnergy flattening_energy(const FabricLaw& law, const TargetTriangle& target, const PlaneCorners& uv,
                                 Vector6* gradient);
Matrix6 flattening_hessian(const FabricLaw& law, const TargetTriangle& target, const PlaneCorners& uv,
                           Curvature curvature);

}  // namespace toile
