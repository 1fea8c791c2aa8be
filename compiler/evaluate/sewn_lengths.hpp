// `front.sewn.waist`: how long an edge is once its darts are closed and its pleats are folded.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

/// A record with the lengths of all edges of the piece, of one copy where there are two; unknown for a piece that
/// cannot be cut, which is told where it is drawn.
Value sewn_lengths(Session& session, PieceInstance& piece);

}  // namespace toile
