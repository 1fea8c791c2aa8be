// The garment's worn lines on the sewn surface.
#pragma once

#include "compiler/smesh/smesh.hpp"

namespace toile {

/// One for each of Garment::wears, in order. A vertex that the chain comes by again is listed once.
std::vector<SMesh::WornLine> find_worn_lines(const Garment& garment, const PMesh& p, const SMesh& s);

}  // namespace toile
