// Slash and spread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/pattern/draft.hpp"
#include "compiler/pattern/findings.hpp"

namespace toile {

/// A piece whose slashes have been opened, and what that did to places on its edges.
struct SpreadPiece {
  struct Gap {
    std::string edge;
    double at = 0;     // [m] along the edge as drawn
    double width = 0;  // [m]
  };
  DraftPiece piece;
  std::vector<Gap> gaps;

  /// Where a place on a drawn edge has come to lie along the edge [m].
  double moved(const std::string& edge, double at) const;
};

/// Opens all slashes of a piece at once. The panel with the fold, else the one where the outline begins, keeps its
/// place. An edge that is slashed is drawn anew, smoothly from the middle of each of its parts to the middle of the
/// next, and is as long as its parts and gaps together: one in which slashes are hinged keeps its length. Nothing after
/// a mistake.
std::optional<SpreadPiece> spread_out(const DraftPiece& draft, Findings& findings);

}  // namespace toile
