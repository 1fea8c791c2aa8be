#include <algorithm>
#include <cmath>
#include <cstddef>

#include "runtime/mesh/index.hpp"

#include "runtime/render/surface.hpp"

namespace toile {
namespace {

/// How far the middle of the cubic arc over ab, at right angles to the two normals at its ends, lies off the chord's.
Vec3 sagitta(Vec3 a, Vec3 b, Vec3 normal_a, Vec3 normal_b) {
  const Vec3 chord = b - a;
  const Vec3 off = (-1.0 / 8) * (dot(chord, normal_a) * normal_a - dot(chord, normal_b) * normal_b);
  const double most = norm(chord) / 6;  // a wild normal must not throw a spike
  const double length = norm(off);
  return length > most ? (most / length) * off : off;
}

/// The two neighbours of every vertex along the free edge it lies on.
class FreeEdges {
 public:
  FreeEdges(const Surface& surface, const EdgeTable& edges) : surface_(surface), neighbours_(surface.points.size()) {
    for (std::size_t e = 0; e < edges.vertices.size(); ++e) {
      if (edges.wings[e].size() != 1) continue;
      const auto [a, b] = edges.vertices[e];
      neighbours_[index(a)].push_back(b);
      neighbours_[index(b)].push_back(a);
    }
  }

  Vec3 middle(int a, int b) const {
    const Vec3 pa = surface_.points[index(a)];
    const Vec3 pb = surface_.points[index(b)];
    return (1.0 / 16) * (9 * (pa + pb) - before(a, b) - before(b, a));
  }

 private:
  /// The point before a on the way to b; a straight prolongation at an end or at a corner of the outline.
  Vec3 before(int a, int b) const {
    const Vec3 pa = surface_.points[index(a)];
    const Vec3 ahead = surface_.points[index(b)] - pa;
    const auto& near = neighbours_[index(a)];
    if (near.size() == 2) {
      const Vec3 behind = pa - surface_.points[index(near[0] == b ? near[1] : near[0])];
      const bool smooth = dot(ahead, behind) > 0.6 * norm(ahead) * norm(behind);
      const bool even = norm(behind) < 3 * norm(ahead) && norm(ahead) < 3 * norm(behind);
      if (smooth && even) return pa - behind;
    }
    return pa - ahead;
  }

  const Surface& surface_;
  std::vector<std::vector<int>> neighbours_;
};

Vec3 middle(const Surface& surface, const EdgeTable& edges, const FreeEdges& free_edges, std::size_t edge) {
  const auto [a, b] = edges.vertices[edge];
  const auto& wings = edges.wings[edge];
  if (wings.size() == 1) return free_edges.middle(a, b);
  const Vec3 pa = surface.points[index(a)];
  const Vec3 pb = surface.points[index(b)];
  Vec3 off;
  for (const int wing : wings) {
    const auto& triangle = surface.triangles[index(wing / 3)];
    const auto& normals = surface.normals[index(wing / 3)];
    const std::size_t first = index((wing % 3 + 1) % 3);
    const std::size_t second = index((wing % 3 + 2) % 3);
    const bool forward = triangle[first] == a;
    off += sagitta(pa, pb, normals[forward ? first : second], normals[forward ? second : first]);
  }
  return 0.5 * (pa + pb) + off / static_cast<double>(wings.size());
}

/// The four parts of a triangle in terms of corners 0, 1, 2 and middles 3 (opposite 0), 4, 5.
constexpr int kParts[4][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}, {3, 4, 5}};

template <typename T>
void divide_linearly(const std::vector<PerCorner<T>>& from, std::vector<PerCorner<T>>& to) {
  to.reserve(4 * from.size());
  for (const auto& c : from) {
    const std::array<T, 6> all{c[0], c[1], c[2], 0.5 * (c[1] + c[2]), 0.5 * (c[2] + c[0]), 0.5 * (c[0] + c[1])};
    for (const auto& part : kParts) to.push_back({all[index(part[0])], all[index(part[1])], all[index(part[2])]});
  }
}

}  // namespace

Surface divided(const Surface& surface, double crease) {
  const EdgeTable edges(surface.triangles);
  const FreeEdges free_edges(surface, edges);
  Surface result;
  result.points = surface.points;
  result.points.reserve(surface.points.size() + edges.vertices.size());
  for (std::size_t e = 0; e < edges.vertices.size(); ++e) {
    result.points.push_back(middle(surface, edges, free_edges, e));
  }
  const int first_middle = static_cast<int>(surface.points.size());
  result.triangles.reserve(4 * surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& corner = surface.triangles[t];
    const auto& edge = edges.edge_of_corner[t];
    const std::array<int, 6> all{
        corner[0], corner[1], corner[2], first_middle + edge[0], first_middle + edge[1], first_middle + edge[2]};
    for (const auto& part : kParts)
      result.triangles.push_back({all[index(part[0])], all[index(part[1])], all[index(part[2])]});
  }
  divide_linearly(surface.uv, result.uv);
  divide_linearly(surface.seam, result.seam);
  divide_linearly(surface.value, result.value);
  result.normals = corner_normals(result.points, result.triangles, EdgeTable(result.triangles), crease);
  return result;
}

}  // namespace toile
