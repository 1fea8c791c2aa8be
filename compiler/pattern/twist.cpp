// Seams that turn a piece over or upside down.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

// Whether the seam lays right side on right side: the cloth of the one chain on its left, of the other on its right.
bool keeps_sides(const Seam& seam) {
  return seam.first.front().forward != seam.second.front().forward;
}

// Pieces in groups; within a group it is known which of them have their right sides on the same side of the cloth.
class Sides {
 public:
  explicit Sides(std::size_t pieces) : group_(pieces), turned_(pieces, false) {
    for (std::size_t i = 0; i < pieces; ++i) group_[i] = i;
  }
  /// False when the two are known to lie the other way.
  bool join(std::size_t a, std::size_t b, bool same) {
    const bool turn = (turned_[a] == turned_[b]) != same;
    if (group_[a] == group_[b]) return !turn;
    const std::size_t from = group_[b], to = group_[a];
    for (std::size_t i = 0; i < group_.size(); ++i) {
      if (group_[i] != from) continue;
      group_[i] = to;
      turned_[i] = turned_[i] != turn;
    }
    return true;
  }

 private:
  std::vector<std::size_t> group_;
  std::vector<bool> turned_;
};

Vec2 chord_of(const std::vector<Piece>& pieces, const Chain& chain) {
  const auto& first = pieces[chain.front().edge.piece].edge(chain.front().edge.edge).curve;
  return first.end() - first.start();  // walked with the cloth on the left
}

}  // namespace

void check_sides(const DraftGarment& draft, const std::vector<std::vector<Seam>>& seams,
                 const std::vector<Piece>& pieces, Findings& findings) {
  Sides sides(pieces.size());
  for (const bool reversed : {false, true}) {  // those said to be reversed are the ones in question
    for (std::size_t i = 0; i < seams.size(); ++i) {
      if (draft.seams[i].reversed != reversed) continue;
      for (const Seam& seam : seams[i]) {
        if (seam.is_layer || seam.first.empty() || seam.second.empty() || is_sewn_upon(seam, pieces)) continue;
        if (sides.join(seam.first.front().edge.piece, seam.second.front().edge.piece, keeps_sides(seam))) continue;
        const std::string message = fmt::format(
            "the seam {} is twisted: it sews the right side of the cloth to the wrong side", quoted(seam.name));
        if (draft.wears.empty()) {  // a Möbius strip by itself is nobody's mistake
          findings.warning("W0337", message, {{seam.written, "sewn start to start"}},
                           "leave out `reversed`, or write `allow W0337` where a one-sided surface is meant");
        } else {
          findings.error("E0335", message, {{seam.written, "sewn start to start"}}, "leave out `reversed`");
        }
        break;
      }
    }
  }
}

std::optional<TwistedSeam> find_twist(const DraftGarment& draft, const std::vector<std::vector<Seam>>& seams,
                                      const std::vector<Piece>& pieces, PieceId a, PieceId b) {
  for (std::size_t i = 0; i < seams.size(); ++i) {
    for (const Seam& seam : seams[i]) {
      const PieceId p = seam.first.front().edge.piece, q = seam.second.front().edge.piece;
      if (p == q || !((p == a && q == b) || (p == b && q == a))) continue;
      if (draft.seams[i].reversed) return TwistedSeam{seam.written, true, ""};
      const Vec2 one = chord_of(pieces, seam.first), other = chord_of(pieces, seam.second);
      const bool both_up = dot(one, other) > 0.8 * norm(one) * norm(other);
      if (!both_up) continue;
      // The edge on the other side of the second piece: as long, and walked the other way.
      const Piece& piece = pieces[q];
      const double wanted = length(pieces, seam.second);
      for (const PieceEdge& edge : piece.edges) {
        const Vec2 way = edge.curve.end() - edge.curve.start();
        const bool opposite = dot(way, other) < -0.8 * norm(way) * norm(other);
        if (!opposite || edge.is_dart_leg || std::abs(edge.curve.length() - wanted) > 0.05 * wanted) continue;
        return TwistedSeam{
            seam.written, false,
            fmt::format("sew {} to `{}.{}`: sewn as it is, {} stands upside down",
                        quoted(draft.seams[i].first.front().piece + "." + draft.seams[i].first.front().edge),
                        piece.drawn_name, edge.name, quoted(piece.drawn_name))};
      }
    }
  }
  return std::nullopt;
}

}  // namespace toile
