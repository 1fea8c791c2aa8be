// The topology of a sewn garment without its meshes.
#pragma once

#include "compiler/smesh/smesh.hpp"

namespace toile {

/// What survey() finds in the meshes of a garment, whatever their fineness, in a thousandth of the time: each piece is
/// taken as one cell, each stretch that is sewn alike as one edge. Vertices, edges and triangles are not counted. A
/// garment with lines inside its pieces, which cut them into several cells, is meshed after all.
Topology sewn_topology(const Garment& garment);

}  // namespace toile
