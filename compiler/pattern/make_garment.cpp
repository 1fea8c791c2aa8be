#include <fmt/format.h>

#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/draft.hpp"
#include "compiler/pattern/findings.hpp"
#include "compiler/pattern/sewing.hpp"

namespace toile {

Garment make_garment(const DraftGarment& draft, std::vector<Diagnostic>& diagnostics) {
  Findings findings(diagnostics);
  Garment garment{draft.name, {}, {}, {}, draft.fabric, draft.textile, draft.drawn_on, draft.written};
  for (const DraftPiece& piece : draft.pieces) {
    for (Piece& cut : cut_piece(piece, findings)) garment.pieces.push_back(std::move(cut));
  }
  if (draft.pieces.empty()) {
    findings.error("E0325", fmt::format("garment {} has no pieces", quoted(draft.name)), {{draft.written, ""}},
                   "draw at least one: `piece front { outline from (0cm, 0cm) { ... } }`");
  }

  SewnCorners corners(garment.pieces);
  garment.seams = dart_seams(garment.pieces, corners);
  const std::vector<std::vector<Seam>> seams = resolve_seams(draft, garment.pieces, corners, findings);
  check_sewn_once(draft, seams, garment.pieces, findings);
  for (const std::vector<Seam>& copies : seams) {
    garment.seams.insert(garment.seams.end(), copies.begin(), copies.end());
  }
  // What hangs together can only be judged when all pieces and seams are known.
  const bool complete = findings.errors() == 0;
  garment.wears = resolve_wears(draft, garment.pieces, corners, complete, findings);
  check_worn_once(garment.wears, garment.pieces, findings);
  check_lengths(draft, seams, garment.pieces, findings);
  if (complete) check_ties(draft, garment, findings);
  return garment;
}

}  // namespace toile
