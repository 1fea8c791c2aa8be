#include "compiler/pattern/arrangements.hpp"

#include <array>
#include <cstddef>

#include "compiler/curve/turn.hpp"

namespace toile {
namespace {

using Triple = std::array<double, 3>;

Triple turned(Triple v, const Triple& angles) {
  for (std::size_t axis = 0; axis < 3; ++axis) v = toile::turned(v, axis, angles[axis]);
  return v;
}

/// A mirrored copy is drawn mirrored in x = 0 already, so that its own x goes the other way.
Arrangement mirrored(Arrangement arrangement) {
  arrangement.origin[0] = -arrangement.origin[0];
  arrangement.up[0] = -arrangement.up[0];
  for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) arrangement.across[k] = -arrangement.across[k];
  return arrangement;
}

}  // namespace

std::vector<Arrangement> resolve_arrangements(const DraftGarment& draft, const std::vector<Piece>& pieces) {
  std::vector<Arrangement> arrangements;
  for (const DraftArrangement& drafted : draft.arrangements) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].drawn_name != drafted.piece) continue;
      const Arrangement drawn{static_cast<PieceId>(i), drafted.at, turned({1, 0, 0}, drafted.turn),
                              turned({0, 0, 1}, drafted.turn), drafted.written};
      arrangements.push_back(pieces[i].side == Side::Mirrored ? mirrored(drawn) : drawn);
    }
  }
  return arrangements;
}

}  // namespace toile
