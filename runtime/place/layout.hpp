// A place in space for a sewn surface that hangs from nothing.
#pragma once

#include <vector>

#include "runtime/mesh/vec3.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// Fills the positions of one component's vertices about the origin, from distances within the cloth: landmark
/// multidimensional scaling (de Silva and Tenenbaum 2004), evened out afterwards. Where four dimensions are needed as
/// much as three (a torus, a Klein bottle), the four are projected from the sphere they nearly lie on, from the point
/// of it farthest from the surface, so that a torus comes out as one. Right sides face outwards where that can be.
void lay_out(const RestMesh& rest, const std::vector<int>& members, std::vector<Vec3>& positions);

}  // namespace toile
