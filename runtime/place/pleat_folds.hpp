// How the creases of pleats lie when a garment is put on.
#pragma once

#include <vector>

#include "compiler/smesh/smesh.hpp"
#include "runtime/place/hanging_chain.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// The folds of a sewn mesh's pleats: of each, the strip of cloth that is turned back between a ridge and its valley.
class PleatFolds {
 public:
  explicit PleatFolds(const SewnMesh& mesh);
  bool empty() const { return strips_.empty(); }

  /// Fractions of a turn round a limb, as winding() gives them, with the pleats folded: cloth that is turned back winds
  /// back.
  void fold(const RestMesh& rest, const HangingChain& chain, const std::vector<bool>& in_component,
            std::vector<double>& fraction) const;
  /// How many layers of cloth lie between a vertex and what the garment is worn on.
  double layers_below(int vertex) const { return layers_[static_cast<std::size_t>(vertex)]; }

 private:
  /// Both lines run the same way; the valley is the nearest one.
  struct Strip {
    PieceId piece = 0;
    LineSegment ridge, valley;

    /// Across the strip, from the ridge on, over its width [m].
    double across(Vec2 p, double& width) const;
  };

  double way_round(const Cloth& cloth, const Strip& strip, const std::vector<double>& fraction) const;

  const SewnMesh& mesh_;
  std::vector<Strip> strips_;
  std::vector<double> layers_;  // of each vertex
};

}  // namespace toile
