// Garments that are worn over each other: the outer one starts outside of the inner.
#pragma once

#include <vector>

#include "runtime/body/body.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// Moves the cloth of each layer but the innermost away from the body until it lies `gap` [m] beyond all that is worn
/// below it, seen along the shortest way from the body. Cloth about another limb is not in the way.
void put_outside(const RestMesh& rest, const Body& body, double gap, std::vector<Vec3>& positions);

}  // namespace toile
