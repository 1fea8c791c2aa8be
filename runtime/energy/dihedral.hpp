// The angle between two triangles at their common edge, with its first and second derivatives.
#pragma once

#include <array>

#include "runtime/mesh/vector.hpp"

namespace toile {

/// Points x0, x1 of the edge, x2 opposite in the triangle (x0, x1, x2), x3 opposite in (x1, x0, x3).
using Hinge = std::array<Vector3, 4>;

/// In (-pi, pi]; zero when flat, positive when the normals lean away from each other (a ridge seen from their side).
double dihedral(const Hinge& x);
Vector12 dihedral_gradient(const Hinge& x);
Matrix12 dihedral_hessian(const Hinge& x);

}  // namespace toile
