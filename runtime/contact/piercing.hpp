// Where an edge of the cloth goes through a triangle of it.
#pragma once

#include <array>
#include <optional>

#include "runtime/mesh/vector.hpp"

namespace toile {

/// Where an edge goes through a triangle, and how that place moves: a vertex moved by m moves it by w (m - e (n.m) /
/// (n.e)) when it is of the edge, and by w e (n.m) / (n.e) when it is of the triangle.
struct Piercing {
  Vector3 at = Vector3::Zero();
  Vector3 edge = Vector3::Zero(), normal = Vector3::Zero();
  std::array<int, 2> edge_vertices{};
  std::array<double, 2> edge_weights{};
  std::array<int, 3> triangle_vertices{};
  std::array<double, 3> triangle_weights{};

  /// What a pull on the place is for the vertices.
  void spread(const Vector3& pull, Vector& gradient) const {
    const double along = edge.dot(normal);
    const Vector3 by_triangle = normal * (edge.dot(pull) / along);
    for (std::size_t k = 0; k < 2; ++k) {
      gradient.segment<3>(3 * edge_vertices[k]) += edge_weights[k] * (pull - by_triangle);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      gradient.segment<3>(3 * triangle_vertices[k]) += triangle_weights[k] * by_triangle;
    }
  }
};

inline Vector3 vertex_at(const Vector& q, int vertex) {
  return q.segment<3>(3 * vertex);
}

/// Of the edge from one vertex to another through a triangle, if it does.
inline std::optional<Piercing> pierce(const Vector& q, int from, int to, const std::array<int, 3>& triangle) {
  const Vector3 a = vertex_at(q, triangle[0]), b = vertex_at(q, triangle[1]), c = vertex_at(q, triangle[2]),
                start = vertex_at(q, from);
  Piercing piercing;
  piercing.normal = (b - a).cross(c - a);
  piercing.edge = vertex_at(q, to) - start;
  const double along = piercing.normal.dot(piercing.edge);
  if (along == 0) return std::nullopt;
  const double t = piercing.normal.dot(a - start) / along;
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  piercing.at = start + t * piercing.edge;
  const double square = piercing.normal.squaredNorm();
  const double wb = (piercing.at - a).cross(c - a).dot(piercing.normal) / square;
  const double wc = (b - a).cross(piercing.at - a).dot(piercing.normal) / square;
  if (!(wb >= 0 && wc >= 0 && wb + wc <= 1)) return std::nullopt;
  piercing.edge_vertices = {from, to};
  piercing.edge_weights = {1 - t, t};
  piercing.triangle_vertices = triangle;
  piercing.triangle_weights = {1 - wb - wc, wb, wc};
  return piercing;
}

}  // namespace toile
