// From a draped mesh to another mesh of the same garment: through the flat pieces, where both meshes lie in one plane.
#pragma once

#include <vector>

#include "compiler/smesh/smesh.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile {

/// Positions for the S-vertices of `to`: each of its P-vertices takes the barycentric mean in the triangle of `from`
/// that it lies in, in the same piece; where pieces are sewn the copies are averaged.
std::vector<Vec3> carry_over(const SewnMesh& from, const std::vector<Vec3>& positions, const SewnMesh& to);

}  // namespace toile
