// Rings of a garment that is worn at several lines, turned so that they agree.
#pragma once

#include <vector>

#include "runtime/place/hanging_chain.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// Where a ring is nearest to another chain in the cloth, as a neckline is to an armhole at the shoulder, there it
/// comes to lie near that one's line on the body. A ring that is off by no more than a little way stays as it was hung.
void turn_to_each_other(const RestMesh& rest, std::vector<HungLine>& hung);

}  // namespace toile
