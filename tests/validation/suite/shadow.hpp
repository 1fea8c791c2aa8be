// The shadow of a cloth from straight above, as the drape tester draws it.
#pragma once

#include <vector>

#include "runtime/mesh/cloth.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile::validation {

/// [m2] of the union of all triangles seen from above, on a raster of a quarter of a millimetre.
double shadow_area(const Cloth& cloth, const std::vector<Vec3>& positions);

}  // namespace toile::validation
