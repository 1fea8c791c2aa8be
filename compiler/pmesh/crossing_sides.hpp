// Chords that cross where their curves do not.
#pragma once

#include "compiler/pmesh/triangulate.hpp"

namespace toile {

/// The given side and those that cross it, each to be split in its middle.
std::vector<OutlineSplit> crossing_sides(const Loops& loops, int loop, int side);

}  // namespace toile
