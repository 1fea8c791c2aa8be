#include "runtime/contact/self_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace toile {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

struct Face {
  int number = 0;
  std::array<int, 3> vertices{};
  Kernel::Triangle_3 triangle;

  /// The side opposite to a corner.
  Kernel::Segment_3 side(int corner) const { return {triangle.vertex(corner + 1), triangle.vertex(corner + 2)}; }
};

bool is_finite(Vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::vector<Face> faces_of(const Cloth& cloth, const std::vector<Vec3>& positions) {
  std::vector<Face> faces;
  faces.reserve(cloth.triangles.size());
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    const ClothTriangle& triangle = cloth.triangles[t];
    std::array<Kernel::Point_3, 3> corners;
    bool sound = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 p = positions[static_cast<std::size_t>(triangle.vertices[i])];
      sound = sound && is_finite(p);
      if (sound) corners[i] = {p.x, p.y, p.z};
    }
    if (!sound || CGAL::collinear(corners[0], corners[1], corners[2])) continue;
    faces.push_back({static_cast<int>(t), triangle.vertices, {corners[0], corners[1], corners[2]}});
  }
  return faces;
}

/// Corners of the two that are the same vertex: how many, and the last such pair.
struct Common {
  int count = 0;
  int first = 0;
  int second = 0;
};

Common common_vertices(const Face& first, const Face& second) {
  Common common;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (first.vertices[static_cast<std::size_t>(i)] != second.vertices[static_cast<std::size_t>(j)]) continue;
      ++common.count;
      common.first = i;
      common.second = j;
    }
  }
  return common;
}

bool meet(const Face& first, const Face& second) {
  const Common common = common_vertices(first, second);
  if (common.count == 0) return CGAL::do_intersect(first.triangle, second.triangle);
  if (common.count > 1) return false;
  // The common part of two triangles is convex: if it is more than the common vertex, it reaches the side opposite to
  // that vertex in one of them.
  return CGAL::do_intersect(first.triangle, second.side(common.second)) ||
         CGAL::do_intersect(second.triangle, first.side(common.first));
}

}  // namespace

std::vector<std::array<int, 2>> intersecting_triangles(const Cloth& cloth, const std::vector<Vec3>& positions) {
  const std::vector<Face> faces = faces_of(cloth, positions);
  std::vector<Box> boxes;
  boxes.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) boxes.emplace_back(faces[i].triangle.bbox(), i);
  std::vector<std::array<int, 2>> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const Face &first = faces[std::min(a.info(), b.info())], &second = faces[std::max(a.info(), b.info())];
    if (meet(first, second)) pairs.push_back({first.number, second.number});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

int intersecting_triangle_pairs(const Cloth& cloth, const std::vector<Vec3>& positions) {
  return static_cast<int>(intersecting_triangles(cloth, positions).size());
}

}  // namespace toile
