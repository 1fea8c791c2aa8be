// Placing what hangs from lines of the body.
#pragma once

#include <vector>

#include "runtime/place/hanging_chain.hpp"
#include "runtime/place/pleat_folds.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// Fills the positions of one component's vertices (`members`, ascending). The chains of `hung` belong to it; each
/// vertex hangs from the line nearest within the cloth, but what lies on the way from a higher line to a lower one
/// hangs from the higher. Legs: see worn_legs.hpp.
void place_worn(const RestMesh& rest, const PleatFolds& folds, const std::vector<int>& members,
                std::vector<HungLine> hung, const Body& body, std::vector<Vec3>& positions);

}  // namespace toile
