// Flat pieces of cloth for tests, without a pattern behind them.
#pragma once

#include <array>
#include <vector>

#include "runtime/mesh/cloth.hpp"

namespace toile {

/// A cloth from triangles over points (x, y). The warp lies at that angle [rad] from x, the weft square to it. Vertex
/// ids are those of `points`, or what `vertices` has for each where the cloth is sewn to itself.
Cloth flat_cloth(const std::vector<Vec2>& points, const std::vector<std::array<int, 3>>& triangles, double warp = 0,
                 const std::vector<int>& vertices = {});

struct Specimen {
  Cloth cloth;
  std::vector<Vec2> points;  // [m]
};

/// How a rectangle is cut into triangles.
struct Cutting {
  int columns = 1, rows = 1;
  double jitter = 0.2;      // part of a cell by which inner points are off their places, so that no symmetry helps
  bool alternating = true;  // the diagonals; otherwise they all lie the same way
};

Specimen rectangle(double width, double height, const Cutting& cutting, double warp = 0);
/// The same with its left side sewn to its right; the points are those of the left side and between.
Specimen tube(double girth, double height, const Cutting& cutting);

}  // namespace toile
