// Where the scissors go: the outline moved outwards by the seam allowances.
#pragma once

#include <vector>

#include "compiler/pattern/pattern.hpp"

namespace toile {

/// A closed polygon [m] to the right of the edges, each by its own allowance, with mitred corners that reach at most
/// twice the wider allowance beyond the corner. Darts are not cut out: the line passes straight across their mouths.
std::vector<Vec2> cut_line(const std::vector<PieceEdge>& edges);

}  // namespace toile
