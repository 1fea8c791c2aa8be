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

/// A piece put into space before it is sewn: where its drawing's origin is, and which way its x and its y go.
struct ArrangedPiece {
  PieceId piece = 0;
  Vec3 origin;      // [m]
  Vec3 across, up;  // unit vectors at right angles
};

struct Placed {
  std::vector<Vec3> positions;  // one a vertex of the S-mesh; finite, no two the same
  std::vector<int> held;        // vertices held for good, ascending
  std::string error;            // empty when all is well: a line the body does not have, …
};

/// A component whose pieces all have their places starts from there. Otherwise it goes around the limb and down it
/// from the worn lines, right side out (docs/bodies.md); a component without a worn line is
/// laid flat above the body, or, without a body, as it is drawn; a sewn one takes its shape from the distances within
/// it. Vertices are outside the body, but for those held on it. Deterministic.
Placed place(const SewnMesh& mesh, const Cloth& cloth, const std::vector<Worn>& worn,
             const std::vector<ArrangedPiece>& arranged, const Body* body);

}  // namespace toile
