#include "runtime/body/pseudonormals.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace toile {
namespace {

double angle_between(Vec3 a, Vec3 b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

}  // namespace

Pseudonormals::Pseudonormals(const Body::Surface& surface) : of_triangle_(surface.triangles.size()) {
  std::vector<Vec3> at_point(surface.points.size());
  std::vector<std::tuple<int, int, int>> sides;  // smaller vertex, greater vertex, 3 * triangle + opposite corner
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& v = surface.triangles[t];
    const Vec3 a = surface.points[v[0]];
    const Vec3 face = normalized(cross(surface.points[v[1]] - a, surface.points[v[2]] - a));
    of_triangle_[t].face = face;
    for (int c = 0; c < 3; ++c) {
      const int i = v[c], j = v[(c + 1) % 3], k = v[(c + 2) % 3];
      const double angle = angle_between(surface.points[j] - surface.points[i], surface.points[k] - surface.points[i]);
      at_point[i] += angle * face;
      sides.emplace_back(std::min(j, k), std::max(j, k), static_cast<int>(3 * t) + c);
    }
  }
  const auto unit_or = [](Vec3 n, Vec3 otherwise) { return norm(n) > 1e-12 ? normalized(n) : otherwise; };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Normals& normals = of_triangle_[t];
    for (int c = 0; c < 3; ++c) normals.corner[c] = unit_or(at_point[surface.triangles[t][c]], normals.face);
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {  // closed and manifold: they come in pairs
    const int first = std::get<2>(sides[i]), second = std::get<2>(sides[i + 1]);
    const Vec3 face = of_triangle_[first / 3].face;
    const Vec3 normal = unit_or(face + of_triangle_[second / 3].face, face);
    of_triangle_[first / 3].edge[first % 3] = of_triangle_[second / 3].edge[second % 3] = normal;
  }
}

Vec3 Pseudonormals::at(int triangle, const ClosestOnTriangle& where) const {
  const Normals& normals = of_triangle_[triangle];
  switch (where.feature) {
    case ClosestOnTriangle::Feature::Edge:
      return normals.edge[where.corner];
    case ClosestOnTriangle::Feature::Corner:
      return normals.corner[where.corner];
    case ClosestOnTriangle::Feature::Face:
      break;
  }
  return normals.face;
}

}  // namespace toile
