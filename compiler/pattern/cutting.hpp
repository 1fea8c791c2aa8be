// From a drafted piece to the pieces of cloth that are cut from it. The steps work on a Piece that starts as the drawn
// outline and grows: its darts are cut, then it is unfolded or copied.
#pragma once

#include <optional>
#include <vector>

#include "compiler/pattern/draft.hpp"
#include "compiler/pattern/findings.hpp"
#include "compiler/pattern/pattern.hpp"

namespace toile {

/// A drafted outline brought to counter-clockwise order.
struct DrawnPiece {
  Piece piece;
  bool as_drawn = true;  // the outline is walked in the direction of drawing
};

/// Checks the outline by itself: names, lengths, closure, crossings, area. False when it cannot be cut.
bool check_outline(const DraftPiece& draft, Findings& findings);
bool check_holes(const DraftPiece& draft, Findings& findings);

/// For an outline that passed its check: edges with their allowances, holes clockwise.
DrawnPiece drawn_piece(const DraftPiece& draft);

/// The index of the named edge in the outline, or reports it as unknown ("`fold` names …").
std::optional<int> find_edge(const DraftPiece& draft, const std::string& edge, Location written, Findings& findings);

/// Cuts the darts as wedges into the drawn outline and sets the notches on the edges that remain.
bool cut_darts_and_notches(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings);

/// Whether the piece can be laid on its fold: the edge is straight and all cloth lies on one side of it.
bool check_fold(const DraftPiece& draft, const DrawnPiece& drawn, Findings& findings);
/// Both halves of a piece on the fold as one.
Piece unfolded(const Piece& half, const std::string& fold);
/// The other piece of a mirrored pair, reflected in the line x = 0.
Piece mirrored_copy(const Piece& piece);

/// All of the above: one piece, or two for a mirrored pair; none when an error was found.
std::vector<Piece> cut_piece(const DraftPiece& draft, Findings& findings);

}  // namespace toile
