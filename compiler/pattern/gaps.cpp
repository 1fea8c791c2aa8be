// Seams whose line jumps from one place of a piece to another.
#include <fmt/format.h>

#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

struct Gap {
  ChainLink before, after;
};

// Two neighbours on one piece that do not meet at a corner. Between pieces there is nothing to say: they lie side by
// side as the seam lays them.
std::vector<Gap> gaps_of(const Chain& chain, const SewnCorners& corners) {
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    if (chain[i].edge.piece != chain[i + 1].edge.piece || corners.end(chain[i]) == corners.start(chain[i + 1]))
      continue;
    gaps.push_back({chain[i], chain[i + 1]});
  }
  return gaps;
}

Vec2 end_of(const Garment& garment, const ChainLink& link, bool start) {
  const Curve& curve = garment.pieces[link.edge.piece].edge(link.edge.edge).curve;
  return start == link.forward ? curve.start() : curve.end();
}

}  // namespace

void check_gaps(const Garment& garment, Findings& findings) {
  const SewnCorners bare(garment.pieces);
  for (const Seam& seam : garment.seams) {
    if (seam.is_dart || seam.is_pleat) continue;
    if (gaps_of(seam.first, bare).empty() && gaps_of(seam.second, bare).empty()) continue;
    SewnCorners others(garment.pieces);  // what the other seams join is no gap
    for (const Seam& other : garment.seams) {
      if (&other != &seam) others.sew(other);
    }
    for (const Chain* chain : {&seam.first, &seam.second}) {
      const std::vector<Gap> gaps = gaps_of(*chain, others);
      if (gaps.empty()) continue;
      const Piece& piece = garment.pieces[gaps.front().before.edge.piece];
      const PieceEdge& before = piece.edge(gaps.front().before.edge.edge);
      const PieceEdge& after = piece.edge(gaps.front().after.edge.edge);
      const double width =
          distance(end_of(garment, gaps.front().before, false), end_of(garment, gaps.front().after, true));
      findings.warning(
          "W0338",
          fmt::format("the line of a seam jumps by {}: {} does not run on into {}", in_cm(width),
                      quoted(piece.drawn_name + "." + before.name), quoted(piece.drawn_name + "." + after.name)),
          {{seam.written, "sewn as one line"}, {before.written, "ends here"}, {after.written, "and goes on here"}},
          "sew each by itself, or write `allow W0338` where the gap is closed by this seam");
      break;
    }
  }
}

}  // namespace toile
