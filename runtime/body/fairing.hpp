// Blends between parts of a surface that were built apart.
#pragma once

#include <vector>

#include "runtime/body/body.hpp"

namespace toile {

/// Moves the free vertices to where the sum of squares of the umbrella vectors (mean of the neighbours minus the
/// vertex) over them and their neighbours is least: a discrete thin plate that meets the fixed part tangentially
/// (Kobbelt et al. 1998). Unique as long as every free vertex hangs together with a fixed one.
void fair(Body::Surface& surface, const std::vector<bool>& free);

}  // namespace toile
