#include "runtime/place/rest_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace toile {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The time at which a plane front that passed a and b at the times ta and tb arrives at the origin from within their
// angle; infinite when it comes from elsewhere.
double front_arrival(Vec2 a, double ta, Vec2 b, double tb) {
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b);
  const double det = aa * bb - ab * ab;
  if (!(det > 1e-12 * aa * bb)) return infinite;
  const double q11 = bb / det, q12 = -ab / det, q22 = aa / det;  // inverse of the Gram matrix
  const double ones = q11 + 2 * q12 + q22;
  const double mixed = (q11 + q12) * ta + (q12 + q22) * tb;
  const double times = q11 * ta * ta + 2 * q12 * ta * tb + q22 * tb * tb;
  const double discriminant = mixed * mixed - ones * (times - 1);
  if (discriminant < 0) return infinite;
  const double t = (mixed + std::sqrt(discriminant)) / ones;
  const double da = ta - t, db = tb - t;
  const bool comes_between = q11 * da + q12 * db < 0 && q12 * da + q22 * db < 0;
  return comes_between && t >= std::max(ta, tb) ? t : infinite;
}

}  // namespace

RestMesh::RestMesh(const Cloth& cloth) : cloth_(&cloth), triangles_at_(static_cast<std::size_t>(cloth.vertex_count)) {
  edge_length_.reserve(cloth.edges.size());
  for (const SMesh::Edge& edge : cloth.edges) {
    double sum = 0;
    for (const SMesh::Wing& wing : edge.wings) {
      const auto& uv = cloth.triangles[wing.triangle].uv;
      sum += distance(uv[(wing.corner + 1) % 3], uv[(wing.corner + 2) % 3]);
    }
    edge_length_.push_back(sum / static_cast<double>(std::max<std::size_t>(1, edge.wings.size())));
    mean_edge_ += edge_length_.back();
  }
  mean_edge_ /= static_cast<double>(std::max<std::size_t>(1, edge_length_.size()));
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    for (const int v : cloth.triangles[t].vertices) triangles_at_[v].push_back(static_cast<int>(t));
  }
}

std::vector<double> RestMesh::distance_from(const std::vector<int>& sources) const {
  std::vector<double> time(triangles_at_.size(), infinite);
  std::vector<bool> settled(triangles_at_.size(), false);
  using Arrival = std::pair<double, int>;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> front;
  for (const int v : sources) {
    time[v] = 0;
    front.emplace(0, v);
  }
  const auto offer = [&](int v, double t) {
    if (settled[v] || t >= time[v]) return;
    time[v] = t;
    front.emplace(t, v);
  };
  while (!front.empty()) {
    const auto [t, v] = front.top();
    front.pop();
    if (settled[v]) continue;
    settled[v] = true;
    for (const int index : triangles_at_[v]) {
      const ClothTriangle& triangle = cloth_->triangles[index];
      for (int c = 0; c < 3; ++c) {
        if (triangle.vertices[c] != v) continue;
        for (int side = 1; side <= 2; ++side) {
          const int to = (c + side) % 3, other = (c + 3 - side) % 3;
          const Vec2 from = triangle.uv[c] - triangle.uv[to];
          offer(triangle.vertices[to], t + norm(from));
          const int w = triangle.vertices[other];
          if (!settled[w]) continue;
          offer(triangle.vertices[to], front_arrival(from, t, triangle.uv[other] - triangle.uv[to], time[w]));
        }
      }
    }
  }
  return time;
}

}  // namespace toile
