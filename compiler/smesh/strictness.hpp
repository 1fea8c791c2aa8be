// Where a sewn mesh is no simplicial complex in the strict sense.
#pragma once

#include <array>
#include <vector>

#include "compiler/smesh/smesh.hpp"

namespace toile {

/// An edge of the P-mesh to be made finer: its S-edge also stands for another that no seam joins to it, its ends are
/// one S-vertex, or its triangle has the same three S-vertices as another.
struct Breach {
  std::array<int, 2> points{};  // P-vertices
  std::vector<int> facing;      // the third P-vertices of its triangles
  bool on_outline = false;
};

/// In a stable order; empty for a strict complex.
std::vector<Breach> find_breaches(const PMesh& p, const SMesh& s);

}  // namespace toile
