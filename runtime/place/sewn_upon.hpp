// Cloth that lies upon other cloth where lines inside a piece are sewn: patch pockets, tucks.
#pragma once

#include <vector>

#include "compiler/smesh/smesh.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile {

/// Where a piece is sewn by its edges to a line inside another, it starts on that one's right side as the drawings
/// tell: each of its places over the place of the other that it comes to lie on. What reaches beyond the other piece,
/// as a flounce may, stays where it is but for a step off it. Where two lines inside one piece are sewn to each other
/// the strip between them, a tuck, starts folded double on the right side of it. All else has its positions.
void lay_upon(const SewnMesh& mesh, std::vector<Vec3>& positions);

}  // namespace toile
