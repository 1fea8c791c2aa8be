#include "runtime/import/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "compiler/curve/turn.hpp"

namespace toile {
namespace {

using Triple = std::array<double, 3>;

constexpr double degree = std::numbers::pi / 180;

/// The source's frame has y up and z to the front.
Triple from_source(const Triple& v) {
  return {v[0], -v[2], v[1]};
}

Triple cross_product(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

ScriptPlace script_place(const ForeignPlacement& placement, bool is_mirrored) {
  const auto source_axis = [&](Triple axis) {
    for (std::size_t k = 0; k < 3; ++k) axis = turned(axis, k, placement.rotation[k] * degree);
    return from_source(axis);
  };
  ScriptPlace place;
  place.at = from_source(placement.translation);
  for (double& coordinate : place.at) coordinate /= 100;
  // What the turns make of x, y and z.
  const Triple x = source_axis({is_mirrored ? -1.0 : 1.0, 0, 0}), z = source_axis({0, 1, 0});
  const Triple y = cross_product(z, x);
  const double rise = std::clamp(-x[2], -1.0, 1.0);
  place.turn[1] = std::asin(rise) / degree;
  if (std::abs(rise) < 1 - 1e-12) {
    place.turn[0] = std::atan2(y[2], z[2]) / degree;
    place.turn[2] = std::atan2(x[1], x[0]) / degree;
  } else {  // the first and the last axis are one
    place.turn[2] = std::atan2(-y[0], y[1]) / degree;
  }
  return place;
}

}  // namespace toile
