// A drafted outline as a piece: counter-clockwise, each edge with its allowance.
#include <algorithm>

#include "compiler/diag/nearest.hpp"
#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

/// The edge's own allowance, or the general one; its corners by its own word, or by the general one.
DraftAllowance allowance_of(const DraftPiece& draft, const std::string& edge) {
  DraftAllowance found;
  for (const DraftAllowance& allowance : draft.allowances) {
    if (!allowance.edge.empty() && allowance.edge != edge) continue;
    found.width = allowance.width;
    if (allowance.corner) found.corner = allowance.corner;
  }
  return found;
}

// As seams name them: behind what they are drawn in.
std::vector<PieceEdge> named(const DraftPiece& draft, const std::vector<DraftEdge>& drafted, const std::string& inner) {
  std::vector<PieceEdge> edges;
  edges.reserve(drafted.size());
  for (const DraftEdge& edge : drafted) {
    const std::string name = inner.empty() ? edge.name : inner + "." + edge.name;
    const DraftAllowance allowance = allowance_of(draft, name);
    PieceEdge& made =
        edges.emplace_back(PieceEdge{name, Side::Drawn, 0, false, edge.curve, allowance.width, edge.written});
    made.drawn = {0, edge.curve.length()};
    made.corner = allowance.corner.value_or(AllowanceCorner::Mitred);
  }
  return edges;
}

// The edges as a loop that runs to the left (or to the right) of what it bounds; says whether it was turned round.
std::vector<PieceEdge> directed(const DraftPiece& draft, const std::vector<DraftEdge>& drafted, const std::string& hole,
                                bool left, std::vector<bool>& as_drawn) {
  std::vector<PieceEdge> edges = named(draft, drafted, hole);
  as_drawn.push_back((signed_area(whole_outline(edges)) > 0) == left);
  if (as_drawn.back()) return edges;
  std::reverse(edges.begin(), edges.end());
  for (PieceEdge& edge : edges) {
    edge.curve = edge.curve.reversed();
    edge.against_drawing = true;
    edge.drawn = {0, edge.curve.length()};
  }
  return edges;
}

}  // namespace

DrawnPiece drawn_piece(const DraftPiece& draft) {
  DrawnPiece drawn;
  Piece& piece = drawn.piece;
  piece.name = draft.name;
  piece.drawn_name = draft.name;
  piece.warp = draft.warp;
  piece.free_grain = draft.free_grain;
  piece.quantity = draft.mirrored ? std::max(1, draft.quantity / 2) : draft.quantity;
  piece.fabric = draft.fabric;
  piece.plies = draft.plies;
  piece.chart = draft.chart;
  piece.written = draft.written;
  piece.edges = directed(draft, draft.outline, "", true, drawn.as_drawn);
  for (const DraftInner& hole : draft.holes) {
    piece.holes.push_back(directed(draft, hole.edges, hole.name, false, drawn.as_drawn));
  }
  for (const DraftInner& line : draft.lines) {
    piece.lines.push_back(named(draft, line.edges, line.name));
    for (PieceEdge& edge : piece.lines.back()) edge.allowance = 0;  // nothing is cut there
    drawn.as_drawn.push_back(true);
  }
  piece.marks = draft.marks;
  piece.spots = draft.spots;
  piece.label = draft.label;
  return drawn;
}

const DraftEdge* find_edge(const DraftPiece& draft, const std::string& edge, Location written, Findings& findings) {
  if (const DraftEdge* found = drafted_edge(draft, edge)) return found;
  std::vector<std::string> names;
  for (const DraftEdge& each : draft.outline) names.push_back(each.name);
  for (const auto* inner : {&draft.holes, &draft.lines}) {
    for (const DraftInner& each : *inner) {
      for (const DraftEdge& own : each.edges) names.push_back(each.name + "." + own.name);
    }
  }
  findings.error("E0308", "piece " + quoted(draft.name) + " has no edge named " + quoted(edge),
                 {{written, "unknown edge"}, {draft.written, "the piece"}}, suggestion(edge, names));
  return nullptr;
}

}  // namespace toile
