// A bounding volume hierarchy over the triangles of a surface, for nearest points.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "runtime/body/body.hpp"
#include "runtime/body/closest_point.hpp"

namespace toile {

struct BoundingBox {
  Vec3 low{1e300, 1e300, 1e300};
  Vec3 high{-1e300, -1e300, -1e300};
  void include(Vec3 p);
  void include(const BoundingBox& other);
  double half_area() const;
  double squared_distance(Vec3 p) const;
};

/// Four children a node, tested together in single precision: boxes are widened so that rounding never hides a
/// triangle. Distances themselves are in double precision.
class TriangleTree {
 public:
  explicit TriangleTree(const Body::Surface& surface);

  struct Hit {
    int triangle = -1;  // none within the bound
    double squared = std::numeric_limits<double>::infinity();
    ClosestOnTriangle where;
  };
  /// The nearest point no farther than `bound` [m]. Of triangles equally near the first counts, so the answer depends
  /// neither on the bound nor on the tree.
  Hit nearest(Vec3 p, double bound) const;
  /// Calls visit(Hit) for every triangle closer to p than `radius` [m], in an order of the tree's own.
  template <class Visit>
  void within(Vec3 p, double radius, Visit visit) const;
  const BoundingBox& bounds() const { return bounds_; }

  static constexpr int width = 4;
  struct Node {
    // [x, y, z][child]
    std::array<std::array<float, width>, 3> low, high;
    std::array<std::int32_t, width> child;  // a node, or the first triangle of a leaf
    std::array<std::int32_t, width> count;  // of a leaf's triangles; 0 for a node; -1 for none
  };

 private:
  struct Corners {
    Vec3 a, b, c;
  };
  BoundingBox bounds_;
  std::vector<Node> nodes_;
  std::vector<Corners> corners_;  // in the order of the leaves
  std::vector<int> triangle_of_;
};

template <class Visit>
void TriangleTree::within(Vec3 p, double radius, Visit visit) const {
  const double limit = radius * radius;
  const auto reaches = [&](const Node& node, int c) {
    const auto apart = [&](double at, int k) { return std::max({node.low[k][c] - at, 0.0, at - node.high[k][c]}); };
    const double x = apart(p.x, 0), y = apart(p.y, 1), z = apart(p.z, 2);
    return node.count[c] >= 0 && x * x + y * y + z * z < limit * (1 + 2e-6);
  };
  std::array<std::int32_t, 128> stack;  // depth times three, and a node's four children
  int height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const Node& node = nodes_[stack[--height]];
    for (int c = 0; c < width; ++c) {
      if (!reaches(node, c)) continue;
      if (node.count[c] == 0) stack[height++] = node.child[c];
      for (int i = node.child[c]; i < node.child[c] + node.count[c]; ++i) {
        const ClosestOnTriangle where = closest_on_triangle(p, corners_[i].a, corners_[i].b, corners_[i].c);
        const double squared = dot(p - where.point, p - where.point);
        if (squared < limit) visit(Hit{triangle_of_[i], squared, where});
      }
    }
  }
}

}  // namespace toile
