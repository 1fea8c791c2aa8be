// Pieces drawn outside of the garments that they are for: with parameters, by a module, or as part of another garment.
#pragma once

#include "compiler/evaluate/call.hpp"
#include "compiler/evaluate/pieces.hpp"

namespace toile {

/// `piece pocket(width = 14cm) { … }`, or a piece at the top of a file.
void define_free_piece(Session& session, Scope& scope, const syntax::Piece& written);

/// The piece drawn for these arguments.
Value instantiate(Session& session, const PieceTemplate& piece, const std::vector<std::optional<Given>>& arguments);

/// `piece cuff = parts.cuff(8cm)` in a garment: the piece that the value is, or with `with { … }` a variation of it.
Value take(Session& session, PieceInstance& piece);

/// The draft of a piece that was taken, under the name that it has here.
DraftPiece draft_taken(Session& session, PieceInstance& piece);

}  // namespace toile
