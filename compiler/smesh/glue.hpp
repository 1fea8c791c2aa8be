// Unifies what seams join.
#pragma once

#include "compiler/smesh/smesh.hpp"

namespace toile {

/// The S-mesh of a garment's P-mesh as it is, strict or not; topology and worn lines not yet filled in. Where an edge
/// has more than two wings, those come first that the seam itself joins, not a layer of it or a pleat: bending acts
/// between the first two. Where a piece is sewn upon another the other's own two wings come first, and where two pieces
/// are stitched to each other along lines inside both, the two of each. A tuck runs on from the cloth before it to the
/// cloth behind it.
SMesh glue(const Garment& garment, const PMesh& mesh);

}  // namespace toile
