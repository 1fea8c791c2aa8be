#include "runtime/contact/neighbours.hpp"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstddef>
#include <span>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

using SweptBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

class Sweep {
 public:
  Sweep(const Vector& from, const Vector& to, double margin) : from_(from), to_(to), margin_(margin) {}

  SweptBox box(std::span<const int> vertices, int info) const {
    Eigen::Array3d low = from_.segment<3>(3 * vertices[0]).array(), high = low;
    for (const int v : vertices) {
      for (const Vector* at : {&from_, &to_}) {
        const Eigen::Array3d x = at->segment<3>(3 * v).array();
        low = low.min(x);
        high = high.max(x);
      }
    }
    low -= margin_;
    high += margin_;
    return {low.data(), high.data(), info};
  }

 private:
  const Vector& from_;
  const Vector& to_;
  double margin_;
};

bool before(const Pair& a, const Pair& b) {
  return a.first != b.first ? a.first < b.first : a.second < b.second;
}

void add_corner_pairs(const Cloth& cloth, const Sweep& sweep, const std::vector<SweptBox>& triangles,
                      std::vector<Pair>& pairs) {
  std::vector<SweptBox> corners, faces = triangles;
  for (int v = 0; v < cloth.vertex_count; ++v) corners.push_back(sweep.box({&v, 1}, v));
  CGAL::box_intersection_d(corners.begin(), corners.end(), faces.begin(), faces.end(),
                           [&](const SweptBox& corner, const SweptBox& face) {
                             const auto& of = cloth.triangles[index(face.info())].vertices;
                             const int v = corner.info();
                             if (v == of[0] || v == of[1] || v == of[2]) return;
                             pairs.push_back({Pair::Kind::CornerTriangle, v, face.info(), {v, of[0], of[1], of[2]}});
                           });
}

void add_edge_pairs(const Cloth& cloth, const Sweep& sweep, std::vector<Pair>& pairs) {
  std::vector<SweptBox> edges;
  for (int e = 0; e < cloth.edge_count; ++e) edges.push_back(sweep.box(cloth.edges[index(e)].vertices, e));
  CGAL::box_self_intersection_d(edges.begin(), edges.end(), [&](const SweptBox& one, const SweptBox& other) {
    const int first = std::min(one.info(), other.info()), second = std::max(one.info(), other.info());
    const auto &a = cloth.edges[index(first)].vertices, &b = cloth.edges[index(second)].vertices;
    if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) return;
    pairs.push_back({Pair::Kind::EdgeEdge, first, second, {a[0], a[1], b[0], b[1]}});
  });
}

}  // namespace

std::vector<Pair> neighbours(const Cloth& cloth, const Vector& from, const Vector& to, double margin) {
  const Sweep sweep(from, to, margin);
  std::vector<SweptBox> triangles;
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    triangles.push_back(sweep.box(cloth.triangles[t].vertices, static_cast<int>(t)));
  }
  std::vector<Pair> pairs;
  add_corner_pairs(cloth, sweep, triangles, pairs);
  std::sort(pairs.begin(), pairs.end(), before);
  const auto corners = static_cast<std::ptrdiff_t>(pairs.size());
  add_edge_pairs(cloth, sweep, pairs);
  std::sort(pairs.begin() + corners, pairs.end(), before);
  return pairs;
}

}  // namespace toile
