#include "compiler/evaluate/sewn_lengths.hpp"

#include <algorithm>

#include "compiler/evaluate/pieces.hpp"
#include "compiler/pattern/cutting.hpp"

namespace toile {
namespace {

/// Pleats run across a piece, and darts are cut where they stand, whatever its edges are sewn to. A mistake is told
/// here: what needs the lengths is not made then.
std::vector<Piece> cut_by_itself(Session& session, DraftPiece draft) {
  std::vector<Diagnostic> found;
  Findings findings(found);
  draft.allowances.clear();
  std::vector<Piece> cut = cut_piece(draft, {}, findings);
  for (Diagnostic& diagnostic : found) session.report.add(std::move(diagnostic));
  return findings.errors() == 0 ? cut : std::vector<Piece>{};
}

}  // namespace

Value sewn_lengths(Session& session, PieceInstance& piece) {
  const DraftPiece draft = draft_piece(session, piece);
  if (!piece.sound) return Unknown{};
  const std::vector<Piece> cut = cut_by_itself(session, draft);
  if (cut.empty()) return Unknown{};
  std::vector<RecordValue::Field> fields;
  for (const DraftEdge& drawn : draft.outline) {
    double length = 0;
    for (const PieceEdge& edge : cut.front().edges) {
      const bool counts =
          edge.name == drawn.name && edge.side == Side::Drawn && !edge.is_dart_leg && !edge.folded_under;
      if (counts) length += edge.curve.length();
    }
    if (draft.fold != drawn.name) fields.push_back({drawn.name, Quantity{dimension::length, length}});
  }
  return record_value(std::move(fields));
}

}  // namespace toile
