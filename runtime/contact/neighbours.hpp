// Which parts of the cloth may come near each other while it moves: corners with triangles, edges with edges.
#pragma once

#include <array>
#include <vector>

#include "runtime/mesh/cloth.hpp"
#include "runtime/mesh/vector.hpp"

namespace toile {

/// A corner and a triangle, or two edges, without a vertex in common.
struct Pair {
  enum class Kind { CornerTriangle, EdgeEdge } kind = Kind::CornerTriangle;
  int first = 0;   // vertex, or edge
  int second = 0;  // triangle, or edge of a higher number
  std::array<int, 4> vertices{};
};

/// All pairs whose swept boxes overlap: each vertex moves from `from` to `to` (three coordinates a vertex), and boxes
/// grow by `margin` [m] on every side. In a fixed order. O(n log n) for a cloth that does not crowd.
std::vector<Pair> neighbours(const Cloth& cloth, const Vector& from, const Vector& to, double margin);

}  // namespace toile
