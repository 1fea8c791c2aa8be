// Flaps: parts of the cloth that hang through other cloth, cut off by the line in which they do.
#pragma once

#include <array>
#include <vector>

#include "runtime/mesh/cloth.hpp"
#include "runtime/mesh/vector.hpp"

namespace toile {

struct FlapPull {
  Vector force;               // on the unknowns, one for each place where an edge goes through
  std::vector<bool> of_flap;  // of each pair of triangles: its line cuts a flap off
};

/// Each line in which the cloth crosses itself that cuts a part off it, be it along a loop or from rim to rim, pulls
/// the smaller part back through (the parts are found as by Baraff, Witkin and Kass, Untangling Cloth, SIGGRAPH 2003).
/// The length of such a line need not fall on the way.
FlapPull pull_flaps(const Cloth& cloth, const Vector& q, const std::vector<std::array<int, 2>>& pairs);

}  // namespace toile
