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
};

/// The middle of the chain's first edge (of its first run on one piece) lies at the line's front, turned by `from`. The
/// chain runs so that the cloth, hanging along the line's axis, shows its right side outwards. A closed chain fills the
/// line; an open one keeps its length.
HangingChain hang(const SewnMesh& mesh, const Worn& worn, const BodyLine& line);

}  // namespace toile
