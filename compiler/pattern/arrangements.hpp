// Pieces put into space as the draft says, their mirrored copies opposite.
#pragma once

#include <vector>

#include "compiler/pattern/draft.hpp"

namespace toile {

std::vector<Arrangement> resolve_arrangements(const DraftGarment& draft, const std::vector<Piece>& pieces);

}  // namespace toile
