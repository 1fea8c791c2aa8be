// Halves on the fold and mirrored pairs: which place of the pattern mirrors which.
#pragma once

#include <array>
#include <vector>

#include "compiler/pattern/pattern.hpp"
#include "compiler/pmesh/pmesh.hpp"

namespace toile {

/// Where a garment is drawn as halves or pairs, a change of its pattern can be made alike on both sides.
class Mirror {
 public:
  /// `mesh` is that of the garment as it was drawn.
  Mirror(const Garment& garment, const PMesh& mesh);

  /// The mean of a change and its mirror image; `change` is by (warp, weft) of each point. Pieces that have no other
  /// half keep theirs.
  std::vector<Vec2> evened(const std::vector<Vec2>& change) const;

 private:
  struct Image {
    std::array<int, 3> points{};
    std::array<double, 3> shares{};
    double across = 0;  // how a change across the warp counts there: -1 or 1
    double along = 0;   // one along it; 0 where there is no image
  };
  std::vector<Image> images_;  // of each point
};

}  // namespace toile
