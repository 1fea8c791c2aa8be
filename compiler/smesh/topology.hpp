// What kind of surface a sewn mesh is.
#pragma once

#include "compiler/smesh/smesh.hpp"

namespace toile {

/// Fills in the topology and the component of each vertex. A boundary is followed from one free edge to the next round
/// the sheet of triangles between them, so that loops which only touch at a vertex are told apart; one that runs into
/// an edge with three triangles or more ends there and counts as a loop. Orientability looks at edges with two
/// triangles.
void survey(SMesh& mesh);

}  // namespace toile
