// A drafted outline as a piece: counter-clockwise, each edge with its allowance.
#include <algorithm>

#include "compiler/curve/places.hpp"
#include "compiler/diag/nearest.hpp"
#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

constexpr double kOnFold = 1e-6;  // [m]

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

void turn_round(std::vector<PieceEdge>& edges) {
  std::reverse(edges.begin(), edges.end());
  for (PieceEdge& edge : edges) {
    edge.curve = edge.curve.reversed();
    edge.against_drawing = true;
    edge.drawn = {0, edge.curve.length()};
  }
}

// The edges as a loop that runs to the left (or to the right) of what it bounds.
std::vector<PieceEdge> directed(const DraftPiece& draft, const std::vector<DraftEdge>& drafted, const std::string& hole,
                                bool left) {
  std::vector<PieceEdge> edges = named(draft, drafted, hole);
  if ((signed_area(whole_outline(edges)) > 0) != left) turn_round(edges);
  return edges;
}

// Puts half a hole into the half's outline, where the fold passes it.
void insert_half(const DraftPiece& draft, const DraftInner& hole, std::vector<PieceEdge>& outline) {
  std::vector<PieceEdge> rim = named(draft, hole.edges, hole.name);
  const Vec2 start = rim.front().curve.start(), end = rim.back().curve.end();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PieceEdge fold = outline[i];
    if (draft.fold != fold.name) continue;
    const double length = fold.curve.length();
    double from = nearest_place(fold.curve, start), to = nearest_place(fold.curve, end);
    if (distance(fold.curve.at(from), start) > kOnFold) continue;  // another part of it
    if (from > to) {
      turn_round(rim);
      std::swap(from, to);
    }
    PieceEdge rest = fold;
    rest.curve = fold.curve.part(to, length);
    outline[i].curve = fold.curve.part(0, from);
    rim.push_back(std::move(rest));
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1, rim.begin(), rim.end());
    return;
  }
}

}  // namespace

bool is_half(const DraftPiece& draft, const DraftInner& hole) {
  const auto fold = std::find_if(draft.outline.begin(), draft.outline.end(),
                                 [&](const DraftEdge& edge) { return draft.fold == edge.name; });
  if (fold == draft.outline.end() || hole.edges.empty()) return false;
  const Vec2 start = hole.edges.front().curve.start(), end = hole.edges.back().curve.end();
  const auto on_fold = [&](Vec2 p) { return distance(fold->curve.at(nearest_place(fold->curve, p)), p) < kOnFold; };
  return distance(start, end) > kOnFold && on_fold(start) && on_fold(end);
}

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
  piece.edges = directed(draft, draft.outline, "", true);
  for (const DraftInner& hole : draft.holes) {
    if (is_half(draft, hole)) {
      insert_half(draft, hole, piece.edges);
    } else {
      piece.holes.push_back(directed(draft, hole.edges, hole.name, false));
    }
  }
  for (const DraftInner& line : draft.lines) {
    piece.lines.push_back(named(draft, line.edges, line.name));
    for (PieceEdge& edge : piece.lines.back()) edge.allowance = 0;  // nothing is cut there
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
