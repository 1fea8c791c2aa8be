// A drafted outline as a piece: counter-clockwise, each edge with its allowance.
#include <algorithm>

#include "compiler/diag/nearest.hpp"
#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

double allowance_of(const DraftPiece& draft, const std::string& edge) {
  double general = 0;
  for (const DraftAllowance& allowance : draft.allowances) {
    if (allowance.edge == edge) return allowance.width;
    if (allowance.edge.empty()) general = allowance.width;
  }
  return general;
}

// The edges as a loop that runs to the left (or to the right) of what it bounds; says whether it was turned round.
std::vector<PieceEdge> directed(const DraftPiece& draft, const std::vector<DraftEdge>& drafted, const std::string& hole,
                                bool left, bool& as_drawn) {
  std::vector<PieceEdge> edges;
  edges.reserve(drafted.size());
  for (const DraftEdge& edge : drafted) {
    const std::string name = hole.empty() ? edge.name : hole + "." + edge.name;
    edges.push_back({name, Side::Drawn, 0, false, edge.curve, allowance_of(draft, name), edge.written});
  }
  as_drawn = (signed_area(whole_outline(edges)) > 0) == left;
  if (as_drawn) return edges;
  std::reverse(edges.begin(), edges.end());
  for (PieceEdge& edge : edges) edge.curve = edge.curve.reversed();
  return edges;
}

}  // namespace

DrawnPiece drawn_piece(const DraftPiece& draft) {
  DrawnPiece drawn;
  Piece& piece = drawn.piece;
  piece.name = draft.name;
  piece.drawn_name = draft.name;
  piece.warp = draft.warp;
  piece.quantity = draft.mirrored ? std::max(1, draft.quantity / 2) : draft.quantity;
  piece.chart = draft.chart;
  piece.written = draft.written;
  piece.edges = directed(draft, draft.outline, "", true, drawn.as_drawn);
  for (const DraftHole& hole : draft.holes) {
    bool hole_as_drawn = true;
    piece.holes.push_back(directed(draft, hole.edges, hole.name, false, hole_as_drawn));
  }
  return drawn;
}

std::optional<int> find_edge(const DraftPiece& draft, const std::string& edge, Location written, Findings& findings) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < draft.outline.size(); ++i) {
    if (draft.outline[i].name == edge) return static_cast<int>(i);
    names.push_back(draft.outline[i].name);
  }
  findings.error("E0308", "piece " + quoted(draft.name) + " has no edge named " + quoted(edge),
                 {{written, "unknown edge"}, {draft.written, "the piece"}}, suggestion(edge, names));
  return std::nullopt;
}

}  // namespace toile
