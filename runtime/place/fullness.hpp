// How much cloth there is around a limb.
#pragma once

#include <vector>

#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// How deep a cloth hangs and how long a whole turn of it is at each depth.
struct Fullness {
  double depth = 0;          // [m]
  double bin = 0;            // [m] width of a bin of `turn`
  std::vector<double> turn;  // [m]
  double turn_at(double at) const;
};

/// Of the vertices marked in `own`, by their fractions of a turn and their depths; `at_chain` is what a turn takes
/// where nothing can be measured.
Fullness measure_fullness(const RestMesh& rest, const std::vector<double>& fraction, const std::vector<double>& depth,
                          const std::vector<bool>& own, double at_chain);

}  // namespace toile
