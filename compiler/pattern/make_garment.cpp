#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "compiler/pattern/arrangements.hpp"
#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/draft.hpp"
#include "compiler/pattern/findings.hpp"
#include "compiler/pattern/sewing.hpp"
#include "compiler/pattern/spread.hpp"

namespace toile {
namespace {

bool is_plain(const DraftGarment& draft) {
  return std::all_of(draft.pieces.begin(), draft.pieces.end(), [](const DraftPiece& p) { return p.spreads.empty(); }) &&
         std::all_of(draft.seams.begin(), draft.seams.end(), [](const DraftSeam& s) { return s.layers.empty(); });
}

template <typename Do>
void for_each_reference(DraftGarment& draft, Do act) {
  for (DraftSeam& seam : draft.seams) {
    for (DraftEdgeRef& reference : seam.first) act(reference);
    for (DraftEdgeRef& reference : seam.second) act(reference);
  }
  for (DraftWear& wear : draft.wears) {
    for (DraftEdgeRef& reference : wear.chain) act(reference);
  }
}

void open_slashes(DraftGarment& draft, Findings& findings) {
  for (DraftPiece& piece : draft.pieces) {
    if (piece.spreads.empty() || !check_outline(piece, findings)) continue;
    const std::optional<SpreadPiece> spread = spread_out(piece, findings);
    if (!spread) continue;
    for_each_reference(draft, [&](DraftEdgeRef& reference) {
      if (reference.piece != piece.name || !reference.part) return;
      reference.part->from = spread->moved(reference.edge, reference.part->from);
      reference.part->to = spread->moved(reference.edge, reference.part->to);
    });
    piece = spread->piece;
  }
}

// Slashes opened, and a seam for each further layer.
DraftGarment prepared(const DraftGarment& draft, Findings& findings) {
  DraftGarment made = draft;
  made.seams.clear();
  for (const DraftSeam& seam : draft.seams) {
    made.seams.push_back(seam);
    for (const std::vector<DraftEdgeRef>& layer : seam.layers) {
      DraftSeam further = seam;
      further.second = layer;
      further.is_layer = true;
      further.notches.clear();
      made.seams.push_back(std::move(further));
    }
  }
  open_slashes(made, findings);
  return made;
}

std::unordered_map<std::string, PieceUse> uses_of(const DraftGarment& draft) {
  std::unordered_map<std::string, PieceUse> uses;
  const auto add = [&](const std::vector<DraftEdgeRef>& references) {
    for (const DraftEdgeRef& reference : references) {
      PieceUse& use = uses[reference.piece];
      use.joined.insert(reference.edge);
      if (!reference.part) continue;
      use.divisions.push_back({reference.edge, reference.part->from});
      use.divisions.push_back({reference.edge, reference.part->to});
    }
  };
  for (const DraftSeam& seam : draft.seams) {
    add(seam.first);
    add(seam.second);
  }
  for (const DraftWear& wear : draft.wears) add(wear.chain);
  return uses;
}

// A sewn piece takes part once, however often it is cut.
void check_quantities(const Garment& garment, Findings& findings) {
  std::set<PieceId> sewn;
  for (const Seam& seam : garment.seams) {
    if (seam.is_dart || seam.is_pleat) continue;
    for (const Chain* chain : {&seam.first, &seam.second}) {
      for (const ChainLink& link : *chain) sewn.insert(link.edge.piece);
    }
  }
  for (const PieceId id : sewn) {
    const Piece& piece = garment.pieces[id];
    if (piece.quantity <= piece.plies || piece.side == Side::Mirrored) continue;
    findings.warning(
        "W0340",
        fmt::format("piece {} is cut {} times, and one of them is sewn", quoted(piece.drawn_name), piece.quantity),
        {{piece.written, "the others are in no seam"}},
        "write `cut 2 mirrored` for a left and a right one, give the other a name of its own, `piece other = " +
            piece.drawn_name + " with { ... }`, or say `plies` for layers that are sewn as one");
  }
}

Garment made_of(const DraftGarment& draft, Findings& findings) {
  Garment garment{draft.name, {}, {}, {}, {}, draft.fabric, draft.textile, draft.drawn_on, draft.written};
  std::unordered_map<std::string, PieceUse> uses = uses_of(draft);
  for (const DraftPiece& piece : draft.pieces) {
    for (Piece& cut : cut_piece(piece, uses[piece.name], findings)) garment.pieces.push_back(std::move(cut));
  }
  if (draft.pieces.empty()) {
    findings.error("E0325", fmt::format("garment {} has no pieces", quoted(draft.name)), {{draft.written, ""}},
                   "draw at least one: `piece front { outline from (0cm, 0cm) { ... } }`");
  }

  SewnCorners corners(garment.pieces);
  garment.seams = dart_seams(garment.pieces, corners);
  const std::vector<std::vector<Seam>> seams = resolve_seams(draft, garment.pieces, corners, findings);
  const std::set<std::size_t> told = check_sewn_once(draft, seams, garment.pieces, findings);
  for (const std::vector<Seam>& copies : seams) {
    garment.seams.insert(garment.seams.end(), copies.begin(), copies.end());
  }
  // What hangs together can only be judged when all pieces and seams are known.
  const bool complete = findings.errors() == 0;
  if (complete) check_sides(draft, seams, garment.pieces, findings);
  check_lengths(draft, seams, garment.pieces, told, findings);
  garment.wears = resolve_wears(draft, garment.pieces, seams, corners, findings.errors() == 0, findings);
  garment.arrangements = resolve_arrangements(draft, garment.pieces);
  check_worn_once(garment.wears, garment.pieces, findings);
  // What follows would only repeat that something is sewn wrongly.
  if (findings.errors() == 0) check_ties(draft, garment, findings);
  if (findings.errors() == 0) check_gaps(garment, findings);
  if (findings.errors() == 0) check_quantities(garment, findings);
  if (findings.errors() == 0) check_worn_sides(draft, garment, corners, findings);
  add_tied_notches(garment.seams, garment.pieces);
  return garment;
}

}  // namespace

Garment make_garment(const DraftGarment& draft, std::vector<Diagnostic>& diagnostics) {
  Findings findings(diagnostics);
  if (is_plain(draft)) return made_of(draft, findings);
  return made_of(prepared(draft, findings), findings);
}

}  // namespace toile
