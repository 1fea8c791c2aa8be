// Notches on the edges that remain, and the lists that the steps after cutting go by.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/pattern/cutting.hpp"

namespace toile {
namespace {

void set_notch(const DraftPiece& draft, const DraftNotch& notch, DrawnPiece& drawn, Findings& findings) {
  const DraftEdge* edge = find_edge(draft, notch.edge, notch.written, findings);
  if (edge == nullptr) return;
  if (draft.fold && notch.edge == *draft.fold) {
    findings.error("E0315", fmt::format("a notch stands on the fold of piece {}", quoted(draft.name)),
                   {{notch.written, "the notch"}, {draft.fold_written, "the fold is no edge of the unfolded piece"}});
    return;
  }
  if (const std::optional<EdgePlace> place = find_place(drawn, notch.edge, notch.at)) {
    drawn.piece.notches.push_back({drawn.number(place->loop, place->edge), place->s, notch.written});
    return;
  }
  const double length = edge->curve.length();
  const bool off = !(notch.at >= 0 && notch.at <= length);
  findings.error("E0313",
                 off ? fmt::format("a notch lies off edge {} of piece {}", quoted(notch.edge), quoted(draft.name))
                     : fmt::format("a notch lies in the mouth of a dart on edge {}", quoted(notch.edge)),
                 {{notch.written, "at " + in_cm(notch.at)}, {edge->written, in_cm(length) + " long"}},
                 off ? "a notch stands between the ends of its edge" : "set it beside the dart");
}

// Parts of an edge are counted as it was drawn.
void number_parts(DrawnPiece& drawn) {
  for (int l = 0; l < drawn.loop_count(); ++l) {
    std::vector<PieceEdge>& loop = drawn.loop(l);
    for (PieceEdge& edge : loop) {
      edge.part = static_cast<int>(std::count_if(loop.begin(), loop.end(), [&](const PieceEdge& other) {
        return !other.is_dart_leg && !edge.is_dart_leg && other.name == edge.name && other.drawn.from < edge.drawn.from;
      }));
    }
  }
}

void list_darts(DrawnPiece& drawn) {
  for (const CutDart& dart : drawn.darts) {
    const auto left = find_leg(drawn, dart.name + ".left"), right = find_leg(drawn, dart.name + ".right");
    if (dart.closed || !left || !right) continue;
    Dart made;
    made.name = dart.name;
    made.left_leg = drawn.number(left->loop, left->edge);
    made.right_leg = drawn.number(right->loop, right->edge);
    made.tip = dart.tip;
    made.written = dart.draft->written;
    made.trued = dart.draft->trued;
    made.pressed = dart.draft->pressed;
    const Curve &first = drawn.piece.edge(made.left_leg).curve, &second = drawn.piece.edge(made.right_leg).curve;
    if (dart.edge.empty()) {
      made.other_tip = first.start();
      made.width = dart.draft->width;
      made.depth = distance(first.start(), dart.tip);
    } else {
      made.width = distance(first.start(), second.end());
      made.depth = distance(0.5 * (first.start() + second.end()), dart.tip);
    }
    drawn.piece.darts.push_back(std::move(made));
  }
}

// The part of the edge that begins or ends at a place as drawn, on the one side of it or the other.
std::optional<int> part_beside(const DrawnPiece& drawn, const std::string& edge, double at, bool beyond) {
  const std::optional<EdgePlace> place = find_place(drawn, edge, at + (beyond ? 1e-5 : -1e-5));
  return place ? std::optional(drawn.number(place->loop, place->edge)) : std::nullopt;
}

void list_turns(DrawnPiece& drawn) {
  for (const CutTurn& turn : drawn.turns) {
    const bool forwards = turn.inner_fold > turn.fold;
    const auto face = part_beside(drawn, turn.edge, turn.fold, !forwards);
    const auto under = part_beside(drawn, turn.edge, turn.fold, forwards);
    const auto back = part_beside(drawn, turn.edge, turn.inner_fold, forwards);
    if (face && under && back) drawn.piece.pleats.push_back({turn.name, *face, *under, *back, turn.written});
  }
}

}  // namespace

bool set_notches(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings) {
  const int before = findings.errors();
  number_parts(drawn);
  list_darts(drawn);
  list_turns(drawn);
  for (const DraftNotch& notch : draft.notches) set_notch(draft, notch, drawn, findings);
  for (const DraftNotch& notch : drawn.fold_notches) {
    if (const std::optional<EdgePlace> place = find_place(drawn, notch.edge, notch.at)) {
      drawn.piece.notches.push_back({drawn.number(place->loop, place->edge), place->s, notch.written});
    }
  }
  return findings.errors() == before;
}

}  // namespace toile
