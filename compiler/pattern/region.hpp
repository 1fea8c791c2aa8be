// The part of the plane that a closed curve bounds.
#pragma once

#include <vector>

#include "compiler/curve/curve.hpp"
#include "compiler/pattern/pattern.hpp"

namespace toile {

/// The area to the left of a closed curve [m2]: positive when it runs counter-clockwise. Exact (Green's theorem).
double signed_area(const Curve& closed);

/// All edges as one curve.
Curve whole_outline(const std::vector<PieceEdge>& edges);

class Region {
 public:
  /// Follows the closed curve within a hundredth of a millimetre.
  explicit Region(const Curve& closed);
  explicit Region(const std::vector<PieceEdge>& loop);
  bool contains(Vec2 point) const;

 private:
  std::vector<Vec2> polygon_;
};

}  // namespace toile
