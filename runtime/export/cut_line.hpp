// Where the scissors go: the outline moved outwards by the seam allowances.
#pragma once

#include <vector>

#include "compiler/pattern/pattern.hpp"

namespace toile {

/// A closed polygon [m] to the right of the edges, each by its own allowance, with corners as they ask for; mitred
/// ones reach at most twice the wider allowance beyond the corner. Darts are not cut out: over the mouth of one that is
/// pressed to a side the line runs so that the folded dart is cut with that side's allowance, else straight across.
std::vector<Vec2> cut_line(const std::vector<PieceEdge>& edges);

}  // namespace toile
