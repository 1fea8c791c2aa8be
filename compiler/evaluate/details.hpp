// What a piece says about its cloth beside its outline: darts, pleats, slashes, notches, marks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Reads the details of a piece whose outline and holes are drafted. False after a mistake, which is reported.
bool read_details(Session& session, const PieceInstance& piece, DraftPiece& draft);

/// Whether cloth can be folded by that angle [rad]; if not that is reported.
bool check_fold(Session& session, double angle, Location written);

/// Reads a line or a place that is marked on the cloth; other statements are passed by. False after a mistake.
bool read_mark(Session& session, const Scope& scope, const syntax::View& written, DraftPiece& draft);

/// The edge of the outline, or of a hole, by its path ("hem", "eye.rim"; `side[3]`); nothing, with an error, when there
/// is none, and nothing alone when its curve is not sound.
std::optional<std::string> named_edge(Session& session, const PieceInstance& piece, const Scope& scope,
                                      const DraftPiece& draft, const syntax::View& reference);

}  // namespace toile
