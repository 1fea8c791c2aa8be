// Elongation of warp and weft and shear of one triangle: E = A (psi_u(|f_u| - 1) + psi_v(|f_v| - 1) + psi_s(phi)),
// where f_u and f_v are the columns of the deformation gradient and phi = asin(f_u . f_v / (|f_u| |f_v|)) (paper,
// section 4: E_au, E_av, E_sh).
#pragma once

#include <array>

#include "compiler/curve/vec2.hpp"
#include "runtime/fabric/law.hpp"
#include "runtime/mesh/vector.hpp"

namespace toile {

/// Gradients of the linear shape functions over (u, v), and the area, of a triangle of the P-mesh.
struct MembraneShape {
  std::array<double, 3> du{};  // [1/m]
  std::array<double, 3> dv{};
  double area = 0;  // [m2]
};
MembraneShape membrane_shape(const std::array<Vec2, 3>& uv);

struct MembraneStrain {
  double warp = 0, weft = 0;  // [1]
  double shear = 0;           // [rad]
};
using Corners = std::array<Vector3, 3>;
MembraneStrain membrane_strain(const MembraneShape& shape, const Corners& x);
/// What the strain becomes when the corners move by dx, to first order.
MembraneStrain foreseen_strain(const MembraneShape& shape, const Corners& x, const Corners& dx);

struct MembraneEnergy {
  double warp = 0, weft = 0, shear = 0;  // [J]
};
using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// Energies; the gradient by the nine coordinates where `gradient` is given. Without a memory shear is on its loading
/// branch.
MembraneEnergy membrane_energy(const FabricLaw& law, const MembraneShape& shape, const Corners& x, Vector9* gradient,
                               const ClothMemory* memory = nullptr);
/// The stresses that turn with the threads are those of the strain `stressed`: the true second derivative where that is
/// the strain at x.
Matrix9 membrane_hessian(const FabricLaw& law, const MembraneShape& shape, const Corners& x,
                         const MembraneStrain& stressed, Curvature curvature, const ClothMemory* memory = nullptr);

/// How the gradient changes where the corners' places in the plane (u0, v0, u1, …) do, and the triangle stays in space.
using Matrix96 = Eigen::Matrix<double, 9, 6>;
Matrix96 membrane_by_pattern(const FabricLaw& law, const MembraneShape& shape, const Corners& x);

}  // namespace toile
