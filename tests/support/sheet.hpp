// Flat sheets of cloth for tests, without a pattern behind them.
#pragma once

#include <array>
#include <vector>

#include "runtime/laboratory/specimen.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile::test {

/// A cloth from triangles in (warp, weft) coordinates; vertex ids are those of `points`.
inline Cloth cloth_of(const std::vector<Vec2>& points, const std::vector<std::array<int, 3>>& triangles) {
  return flat_cloth(points, triangles);
}

using Sheet = Specimen;

/// A rectangle of `columns` x `rows` cells cut into triangles; `jitter` moves inner points by that part of a cell, so
/// that no symmetry of the mesh helps.
inline Sheet rectangle(double width, double height, int columns, int rows, double jitter = 0.2) {
  return toile::rectangle(width, height, {columns, rows, jitter});
}

}  // namespace toile::test
