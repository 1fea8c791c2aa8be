#include <fmt/format.h>

#include "compiler/curve/places.hpp"
#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

bool check_allowances(const DraftPiece& draft, Findings& findings) {
  const int before = findings.errors();
  for (const DraftAllowance& allowance : draft.allowances) {
    if (!allowance.edge.empty()) find_edge(draft, allowance.edge, allowance.written, findings);
  }
  return findings.errors() == before;
}

// A half may keep to its side of the fold and yet meet its own mirror image, where an edge runs along the fold line.
bool check_unfolded(const DraftPiece& draft, const Piece& whole, Findings& findings) {
  const std::vector<Crossing> found = self_crossings(whole_outline(whole.edges));
  if (found.empty()) return true;
  findings.error("E0307",
                 fmt::format("piece {} meets its own other half at ({}, {}) when it is unfolded", quoted(draft.name),
                             in_cm(found[0].point.x), in_cm(found[0].point.y)),
                 {{draft.fold_written, "the fold"}, {draft.written, "the piece"}},
                 "no edge but the fold may lie on the fold line");
  return false;
}

bool check_marks(const DraftPiece& draft, const DrawnPiece& drawn, Findings& findings) {
  const int before = findings.errors();
  const auto check = [&](Vec2 place, Location written) {
    if (in_cloth(drawn, place)) return;
    findings.error(
        "E0336", fmt::format("a mark lies outside of piece {}", quoted(draft.name)),
        {{written, fmt::format("at ({}, {})", in_cm(place.x), in_cm(place.y))}, {draft.written, "the piece"}});
  };
  for (const PointMark& mark : drawn.piece.spots) check(mark.at, mark.written);
  for (const LineMark& mark : drawn.piece.marks) {
    if (mark.kind == LineMark::Kind::Line || mark.kind == LineMark::Kind::Crease)
      check(mark.curve.at(mark.curve.length() / 2), mark.written);
  }
  return findings.errors() == before;
}

// Where a crease meets an edge that edge is divided, so that the mesh folds right up to it.
void divide_at_creases(const DraftPiece& draft, DrawnPiece& drawn) {
  constexpr double kTouches = 1e-6;  // [m]
  for (const LineMark& mark : draft.marks) {
    if (mark.kind != LineMark::Kind::Crease) continue;
    for (const Vec2 end : {mark.curve.start(), mark.curve.end()}) {
      for (const DraftEdge& edge : draft.outline) {
        const double s = nearest_place(edge.curve, end);
        if (distance(edge.curve.at(s), end) < kTouches) divide_at(drawn, edge.name, s);
      }
    }
  }
}

}  // namespace

std::vector<Piece> cut_piece(const DraftPiece& draft, const PieceUse& use, Findings& findings) {
  if (!check_outline(draft, findings)) return {};
  DrawnPiece drawn = drawn_piece(draft);
  // Each check reports for itself, so that one look shows all that is wrong with a piece.
  const bool holes = check_holes(draft, findings);
  const bool inside = holes && check_marks(draft, drawn, findings);
  const bool allowances = check_allowances(draft, findings);
  const bool fold = !draft.fold || check_fold(draft, drawn, findings);
  const bool rims = check_rims(draft, findings);
  // A hole gone astray, or a wrong edge as the fold, would be found at fault again by all that stands on it.
  const bool marks = holes && fold && rims && cut_darts(draft, drawn, findings) &&
                     pivot_darts(draft, drawn, findings) && finish_darts(draft, drawn, findings) &&
                     cut_pleats(draft, use, drawn, findings);
  const bool lines = marks && check_lines(draft, drawn, findings);
  for (const DraftPlace& place : use.divisions) divide_at(drawn, place.edge, place.at);
  divide_at_creases(draft, drawn);
  if (lines) divide_at_lines(draft, drawn);
  const bool notches = fold && set_notches(draft, drawn, findings);
  if (!inside || !holes || !allowances || !fold || !marks || !lines || !notches) return {};
  if (draft.fold) {
    Piece whole = unfolded(drawn.piece, *draft.fold);
    if (!check_unfolded(draft, whole, findings)) return {};
    return {whole};
  }
  if (draft.mirrored) return {drawn.piece, mirrored_copy(drawn.piece)};
  return {drawn.piece};
}

}  // namespace toile
