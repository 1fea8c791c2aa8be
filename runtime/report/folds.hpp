// Folds of a hem, counted along its loop.
#pragma once

#include <optional>
#include <vector>

#include "compiler/smesh/smesh.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile {

/// Closed walks along the edges with one triangle, as vertices. A walk starts at its smallest vertex, towards the
/// smaller of that vertex's neighbours; walks are in the order of their starts. What does not close (the rim of a
/// surface whose edges carry three triangles may end) is left out.
std::vector<std::vector<int>> boundary_loops(const SMesh& mesh);

/// The boundary loop that hangs lowest (least mean height). Loops that lie wholly on lines in `held` (flags of
/// vertices) are not free and do not count.
std::optional<std::vector<int>> lowest_free_loop(const SMesh& mesh, const std::vector<Vec3>& positions,
                                                 const std::vector<bool>& held);

/// How many times a closed line swings out. Its distance from the vertical axis through its centroid is taken along
/// its length and smoothed to its first 32 harmonics; a fold is a maximum that stands out from the valleys about it by
/// more than a twentieth of the mean distance (its topographic prominence). One or two such maxima make an oval, as a
/// tight skirt's hem is, and count as no fold.
int count_folds(const std::vector<Vec3>& loop);

}  // namespace toile
