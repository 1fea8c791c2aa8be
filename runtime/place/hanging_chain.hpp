// Where the vertices of a worn chain go on the body's line.
#pragma once

#include <vector>

#include "runtime/place/line_curve.hpp"
#include "runtime/place/place.hpp"

namespace toile {

struct HangingChain {
  std::vector<int> vertices;
  std::vector<double> fractions;  // of the line, counter-clockwise from the front; not wrapped
  ClosedCurve curve;              // the line, widened to the chain's length where that is longer
  std::vector<Vec3> positions;
  const SMesh::WornLine* worn = nullptr;  // whence it comes
};

struct HungLine {
  const BodyLine* line = nullptr;
  HangingChain chain;
};

/// The chain's centre, the middle of its first edge, lies at the line's front, turned by `from`. The chain runs so that
/// the cloth, hanging along the line's axis, shows its right side outwards. A closed chain fills the line; an open one
/// keeps its length.
HangingChain hang(const SewnMesh& mesh, const Worn& worn, const BodyLine& line);

}  // namespace toile
