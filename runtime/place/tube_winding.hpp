// How far round the limb each vertex of a tube lies that hangs from a closed chain: a sleeve, a skirt.
#pragma once

#include <optional>
#include <vector>

#include "runtime/place/hanging_chain.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// As winding(), for the vertices marked in `own`: the harmonic function that grows by a turn across a cut from the
/// chain to the one free edge. It winds whatever the tube's shape, where layers under a sleeve's high cap would meet
/// before they have gone round. Nothing where the cloth is no tube from the chain to a free edge.
std::optional<std::vector<double>> tube_winding(const RestMesh& rest, const HangingChain& chain,
                                                const std::vector<bool>& own);

}  // namespace toile
