// Initial positions of the sewn surface's vertices (paper, section 3).
#pragma once

#include <string>
#include <vector>

#include "runtime/body/body.hpp"
#include "runtime/mesh/cloth.hpp"

namespace toile {

/// Vertices held or placed at a line of the body.
struct Worn {
  const SMesh::WornLine* line = nullptr;
  std::string body_line;
  bool held = true;
  double from = 0;  // fraction of the line by which the chain's first edge's middle is turned from the front, ccw
};

struct Placed {
  std::vector<Vec3> positions;  // one a vertex of the S-mesh; finite, no two the same
  std::vector<int> held;        // vertices held for good, ascending
  std::string error;            // empty when all is well: a line the body does not have, …
};

/// Around the limb and down it from the worn lines, right side out (docs/bodies.md); a component without a worn line is
/// laid flat above the body, or, without a body, as it is drawn; a sewn one takes its shape from the distances within
/// it. Vertices are outside the body, but for those held on it. Deterministic.
Placed place(const SewnMesh& mesh, const Cloth& cloth, const std::vector<Worn>& worn, const Body* body);

}  // namespace toile
