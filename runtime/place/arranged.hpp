// Placing pieces where the script has put them, and drawing them together along their seams.
#pragma once

#include <string>
#include <vector>

#include "runtime/body/body.hpp"
#include "runtime/place/hanging_chain.hpp"
#include "runtime/place/place.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// True when every piece of the component has its place.
bool is_arranged(const SewnMesh& mesh, const std::vector<int>& members, const std::vector<ArrangedPiece>& arranged);

/// Fills the positions of one component's vertices: each piece lies flat at its place, sewn vertices in the middle of
/// their copies; then all are drawn together until seams are closed as far as the body within allows. Worn chains
/// (`hung`) lie on their lines, turned to where their pieces are.
void place_arranged(const SewnMesh& mesh, const RestMesh& rest, const std::vector<int>& members,
                    const std::vector<ArrangedPiece>& arranged, const std::vector<HungLine>& hung, const Body* body,
                    std::vector<Vec3>& positions);

}  // namespace toile
