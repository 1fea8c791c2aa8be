// Bending in warp and weft and twist of one triangle by mid-edge normals: a rotation unknown on every edge beside the
// positions (Morley's element in the small; Grinspun et al. 2006, docs/mechanics.md). With a_e the angle by which the
// surface's normal at the middle of edge e leans out of the triangle's own, K = (1/A) sum l_e a_e n_e n_e^T, and E = A
// (psi_b(K_uu) + psi_b(K_vv) + 2 D66 K_uv^2) (paper, section 4: E_bu, E_bv, E_tw).
#pragma once

#include <array>

#include "compiler/curve/vec2.hpp"
#include "runtime/fabric/law.hpp"
#include "runtime/mesh/vector.hpp"

namespace toile {

/// What an edge's angle adds to the curvatures, per corner opposite to it [1/m].
struct BendingShape {
  std::array<double, 3> warp{}, weft{}, twist{};
  double area = 0;
};
BendingShape bending_shape(const std::array<Vec2, 3>& uv);

struct Curvatures {
  double warp = 0, weft = 0, twist = 0;  // [1/m]
};
using Angles = std::array<double, 3>;
Curvatures curvatures(const BendingShape& shape, const Angles& angles);

struct BendingEnergy {
  double warp = 0, weft = 0, twist = 0;  // [J]
};
/// `moments`: the derivative by each of the three angles [N m], where given. Without a memory on the loading branch.
BendingEnergy bending_energy(const FabricLaw& law, const BendingShape& shape, const Angles& angles, Angles* moments,
                             const ClothMemory* memory = nullptr);
/// Second derivative by the angles.
Matrix3 bending_hessian(const FabricLaw& law, const BendingShape& shape, const Angles& angles,
                        const ClothMemory* memory = nullptr);

/// How the moments change where the corners' places in the plane (u0, v0, u1, …) do, and the angles stay.
using Matrix36 = Eigen::Matrix<double, 3, 6>;
Matrix36 bending_by_pattern(const FabricLaw& law, const std::array<Vec2, 3>& uv, const Angles& angles);

}  // namespace toile
