#include <algorithm>
#include <cstddef>

#include "runtime/render/surface.hpp"

namespace toile {

EdgeTable::EdgeTable(const std::vector<PerCorner<int>>& triangles) : edge_of_corner(triangles.size()) {
  struct OneSide {
    int from, to;  // smaller first
    int triangle, corner;
  };
  std::vector<OneSide> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const int a = triangles[t][static_cast<std::size_t>((c + 1) % 3)];
      const int b = triangles[t][static_cast<std::size_t>((c + 2) % 3)];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), c});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const OneSide& x, const OneSide& y) {
    return std::array{x.from, x.to, x.triangle, x.corner} < std::array{y.from, y.to, y.triangle, y.corner};
  });
  for (const OneSide& side : sides) {
    if (vertices.empty() || vertices.back() != std::array{side.from, side.to}) {
      vertices.push_back({side.from, side.to});
      wings.emplace_back();
    }
    wings.back().push_back(3 * side.triangle + side.corner);
    edge_of_corner[static_cast<std::size_t>(side.triangle)][static_cast<std::size_t>(side.corner)] =
        static_cast<int>(vertices.size()) - 1;
  }
}

}  // namespace toile
