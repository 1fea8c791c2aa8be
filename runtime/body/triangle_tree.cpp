#include "runtime/body/triangle_tree.hpp"

#include <algorithm>

#include "runtime/body/tree_build.hpp"

namespace toile {
namespace {

// Squared distances from a point to a node's four boxes; plain loops that compilers turn into vector instructions.
std::array<float, TriangleTree::width> squared_distances(const TriangleTree::Node& node,
                                                         const std::array<float, 3>& p) {
  std::array<float, TriangleTree::width> squared{};
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < TriangleTree::width; ++c) {
      const float below = node.low[k][c] - p[k];
      const float beyond = p[k] - node.high[k][c];
      float gap = below > beyond ? below : beyond;
      gap = gap > 0.0F ? gap : 0.0F;
      squared[c] += gap * gap;
    }
  }
  return squared;
}

}  // namespace

void BoundingBox::include(Vec3 p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

void BoundingBox::include(const BoundingBox& other) {
  include(other.low);
  include(other.high);
}

double BoundingBox::half_area() const {
  const Vec3 d = high - low;
  return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
}

double BoundingBox::squared_distance(Vec3 p) const {
  const double x = std::max({low.x - p.x, 0.0, p.x - high.x});
  const double y = std::max({low.y - p.y, 0.0, p.y - high.y});
  const double z = std::max({low.z - p.z, 0.0, p.z - high.z});
  return x * x + y * y + z * z;
}

TriangleTree::TriangleTree(const Body::Surface& surface) {
  std::vector<TreeItem> items;
  items.reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    TreeItem item{{}, {}, static_cast<int>(t)};
    for (const int v : surface.triangles[t]) item.box.include(surface.points[v]);
    item.centre = 0.5 * (item.box.low + item.box.high);
    bounds_.include(item.box);
    items.push_back(item);
  }
  nodes_ = build_tree(items);
  corners_.reserve(items.size());
  for (const TreeItem& item : items) {
    const auto& [a, b, c] = surface.triangles[item.triangle];
    corners_.push_back({surface.points[a], surface.points[b], surface.points[c]});
    triangle_of_.push_back(item.triangle);
  }
}

TriangleTree::Hit TriangleTree::nearest(Vec3 p, double bound) const {
  const std::array<float, 3> single{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  struct Entry {
    float squared;
    std::int32_t child, count;
  };
  std::array<Entry, 128> stack;  // depth times three, and a node's four children
  int height = 0;
  stack[height++] = {0, 0, 0};
  Hit best;
  double limit = bound * bound;
  constexpr double rounding = 1 + 2e-6;  // more than single precision can err on a box far away
  while (height > 0) {
    const Entry entry = stack[--height];
    if (static_cast<double>(entry.squared) > limit * rounding) continue;
    if (entry.count == 0) {
      const Node& node = nodes_[entry.child];
      const auto squared = squared_distances(node, single);
      const int first = height;
      for (int c = 0; c < width; ++c) {
        if (node.count[c] < 0 || static_cast<double>(squared[c]) > limit * rounding) continue;
        // The nearest comes to lie on top.
        int at = height++;
        for (; at > first && stack[at - 1].squared < squared[c]; --at) stack[at] = stack[at - 1];
        stack[at] = {squared[c], node.child[c], node.count[c]};
      }
      continue;
    }
    for (int i = entry.child; i < entry.child + entry.count; ++i) {
      const ClosestOnTriangle where = closest_on_triangle(p, corners_[i].a, corners_[i].b, corners_[i].c);
      const Vec3 d = p - where.point;
      const double squared = dot(d, d);
      if (squared > limit) continue;
      if (squared < best.squared || triangle_of_[i] < best.triangle) {
        best = {triangle_of_[i], squared, where};
        limit = squared;
      }
    }
  }
  return best;
}

}  // namespace toile
