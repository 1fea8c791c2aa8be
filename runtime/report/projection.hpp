// The shadow of a draped cloth.
#pragma once

#include "runtime/mesh/cloth.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile {

/// The area [m2] that the cloth covers seen from above, whatever lies over itself counted once: exact along x, by the
/// midpoint rule of 2048 lines across y, so that its error is of second order in a two-thousandth of the cloth's size.
/// Cusick's drape coefficient is made of it: (this - disc) / (flat cloth - disc).
double projected_area(const Cloth& cloth, const std::vector<Vec3>& positions);

}  // namespace toile
