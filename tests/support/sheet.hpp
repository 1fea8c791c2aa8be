// Flat sheets of cloth for tests, without a pattern behind them.
#pragma once

#include <array>
#include <map>
#include <random>
#include <vector>

#include "runtime/mesh/cloth.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile::test {

/// A cloth from triangles in (warp, weft) coordinates; vertex ids are those of `points`.
inline Cloth cloth_of(const std::vector<Vec2>& points, const std::vector<std::array<int, 3>>& triangles) {
  Cloth cloth;
  cloth.vertex_count = static_cast<int>(points.size());
  cloth.area_of_vertex.assign(points.size(), 0);
  std::map<std::array<int, 2>, int> edge_of;
  for (const auto& corners : triangles) {
    ClothTriangle triangle;
    triangle.vertices = corners;
    for (std::size_t k = 0; k < 3; ++k) triangle.uv[k] = points[static_cast<std::size_t>(corners[k])];
    const double area = 0.5 * cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0]);
    cloth.area += area;
    for (std::size_t k = 0; k < 3; ++k) {
      cloth.area_of_vertex[static_cast<std::size_t>(corners[k])] += area / 3;
      const int a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
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

struct Sheet {
  Cloth cloth;
  std::vector<Vec2> points;  // (u, v) [m]
};

/// A rectangle of `columns` x `rows` cells cut into triangles; `jitter` moves inner points by that part of a cell, so
/// that no symmetry of the mesh helps.
inline Sheet rectangle(double width, double height, int columns, int rows, double jitter = 0.2) {
  Sheet sheet;
  std::mt19937 random(7);
  const auto offset = [&] { return jitter * (static_cast<double>(random() % 2001) / 1000.0 - 1); };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const bool inner_u = i > 0 && i<columns, inner_v = j> 0 && j < rows;
      sheet.points.push_back({width * (i + (inner_u && inner_v ? offset() : 0)) / columns,
                              height * (j + (inner_u && inner_v ? offset() : 0)) / rows});
    }
  }
  std::vector<std::array<int, 3>> triangles;
  const int stride = columns + 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * stride + i, b = a + 1, c = a + stride, d = c + 1;
      if ((i + j) % 2 == 0) {
        triangles.push_back({a, b, d});
        triangles.push_back({a, d, c});
      } else {
        triangles.push_back({a, b, c});
        triangles.push_back({b, d, c});
      }
    }
  }
  sheet.cloth = cloth_of(sheet.points, triangles);
  return sheet;
}

}  // namespace toile::test
