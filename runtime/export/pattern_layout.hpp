// Room on the sheet: where pieces lie, and where in a piece there is space to write.
#pragma once

#include <vector>

#include "compiler/pattern/pattern.hpp"

namespace toile {

struct Box {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};

  void add(Vec2 point);
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
};

/// How far each box must be moved so that all stand side by side on shelves, in order, with tops aligned, `gap` [m]
/// apart, on a sheet of pleasant proportions. The first shelf's tops are at y = 0, further ones lie below; `size` comes
/// out as the width and height of the whole.
std::vector<Vec2> on_shelves(const std::vector<Box>& boxes, double gap, Vec2& size);

/// The same for the pieces of a garment with their allowances.
std::vector<Vec2> on_shelves(const Garment& garment, double gap, Vec2& size);

/// A place in the piece far from its edges, folds and darts, and from those taken already.
struct Spot {
  Vec2 at;
  double clearance = 0;  // [m] to whatever is nearest
};
Spot free_spot(const Piece& piece, const std::vector<Spot>& taken);

}  // namespace toile
