// A better place to start flattening from, for little: the pattern is bent as a whole by a coarse lattice laid over
// each piece, so that the sum over a few of its triangles costs least.
#pragma once

#include <vector>

#include "runtime/develop/flatten.hpp"

namespace toile {

/// Places with no triangle flipped, whose grain lines run as before; the start itself where the lattice does no good.
std::vector<Vec2> coarse_start(const FlatteningInput& input, const FabricLaw& law);

}  // namespace toile
