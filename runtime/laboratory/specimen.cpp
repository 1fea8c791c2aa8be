#include "runtime/laboratory/specimen.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace toile {

Cloth flat_cloth(const std::vector<Vec2>& points, const std::vector<std::array<int, 3>>& triangles, double warp,
                 const std::vector<int>& vertices) {
  const auto vertex = [&](int point) { return vertices.empty() ? point : vertices[static_cast<std::size_t>(point)]; };
  Cloth cloth;
  for (std::size_t p = 0; p < points.size(); ++p) {
    cloth.vertex_count = std::max(cloth.vertex_count, vertex(static_cast<int>(p)) + 1);
  }
  cloth.area_of_vertex.assign(static_cast<std::size_t>(cloth.vertex_count), 0);
  const Vec2 along = {std::cos(warp), std::sin(warp)};
  std::map<std::array<int, 2>, int> edge_of;
  for (const auto& corners : triangles) {
    ClothTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle.vertices[k] = vertex(corners[k]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 point = points[static_cast<std::size_t>(corners[k])];
      triangle.uv[k] = warp == 0 ? point : Vec2{dot(point, along), cross(along, point)};
    }
    const double area = 0.5 * cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0]);
    cloth.area += area;
    for (std::size_t k = 0; k < 3; ++k) {
      cloth.area_of_vertex[static_cast<std::size_t>(triangle.vertices[k])] += area / 3;
      const int a = triangle.vertices[(k + 1) % 3], b = triangle.vertices[(k + 2) % 3];
      const std::array<int, 2> key{std::min(a, b), std::max(a, b)};
      const auto [at, fresh] = edge_of.try_emplace(key, static_cast<int>(cloth.edges.size()));
      if (fresh) cloth.edges.push_back({key, {}, -1});
      triangle.edges[k] = at->second;
      cloth.edges[static_cast<std::size_t>(at->second)].wings.push_back(
          {static_cast<int>(cloth.triangles.size()), static_cast<int>(k)});
    }
    cloth.triangles.push_back(triangle);
  }
  cloth.edge_count = static_cast<int>(cloth.edges.size());
  return cloth;
}

namespace {

struct Grid {
  std::vector<Vec2> points;
  std::vector<std::array<int, 3>> triangles;
};

Grid grid(double width, double height, const Cutting& cutting) {
  Grid grid;
  std::mt19937 random(7);
  const auto offset = [&] { return cutting.jitter * (static_cast<double>(random() % 2001) / 1000.0 - 1); };
  for (int j = 0; j <= cutting.rows; ++j) {
    for (int i = 0; i <= cutting.columns; ++i) {
      const bool inner = i > 0 && i < cutting.columns && j > 0 && j < cutting.rows;
      const double x = i + (inner ? offset() : 0), y = j + (inner ? offset() : 0);
      grid.points.push_back({width * (x / cutting.columns), height * (y / cutting.rows)});
    }
  }
  const int stride = cutting.columns + 1;
  for (int j = 0; j < cutting.rows; ++j) {
    for (int i = 0; i < cutting.columns; ++i) {
      const int a = j * stride + i, b = a + 1, c = a + stride, d = c + 1;
      if (!cutting.alternating || (i + j) % 2 == 0) {
        grid.triangles.push_back({a, b, d});
        grid.triangles.push_back({a, d, c});
      } else {
        grid.triangles.push_back({a, b, c});
        grid.triangles.push_back({b, d, c});
      }
    }
  }
  return grid;
}

}  // namespace

Specimen rectangle(double width, double height, const Cutting& cutting, double warp) {
  const Grid cut = grid(width, height, cutting);
  return {flat_cloth(cut.points, cut.triangles, warp), cut.points};
}

Specimen tube(double girth, double height, const Cutting& cutting) {
  const Grid cut = grid(girth, height, cutting);
  Specimen specimen;
  std::vector<int> vertices;
  for (std::size_t p = 0; p < cut.points.size(); ++p) {
    const int column = static_cast<int>(p) % (cutting.columns + 1), row = static_cast<int>(p) / (cutting.columns + 1);
    vertices.push_back(row * cutting.columns + column % cutting.columns);
    if (column < cutting.columns) specimen.points.push_back(cut.points[p]);
  }
  specimen.cloth = flat_cloth(cut.points, cut.triangles, 0, vertices);
  return specimen;
}

}  // namespace toile
