#include "runtime/place/relax.hpp"

#include "runtime/contact/self_intersections.hpp"

namespace toile {
namespace {

// True when it was too near the body.
bool push_vertex(const Body& body, double clearance, Vec3& p) {
  const auto surface = body.nearest(p, clearance);
  if (!surface || surface->distance >= clearance) return false;
  p += (clearance - surface->distance) * surface->normal;
  return true;
}

void push_vertices(const std::vector<bool>& free, const Body& body, double clearance, std::vector<Vec3>& positions) {
  for (std::size_t v = 0; v < free.size(); ++v) {
    if (free[v]) push_vertex(body, clearance, positions[v]);
  }
}

}  // namespace

void relax(const RestMesh& rest, const std::vector<bool>& free, int passes, const Body* body, double clearance,
           std::vector<Vec3>& positions, int passes_between_pushes) {
  const auto& edges = rest.cloth().edges;
  std::vector<Vec3> shift(free.size());
  std::vector<int> edge_count(free.size(), 0);
  for (const SMesh::Edge& edge : edges) {
    for (const int v : edge.vertices) ++edge_count[v];
  }
  for (int pass = 1; pass <= passes; ++pass) {
    std::fill(shift.begin(), shift.end(), Vec3{});
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto [a, b] = edges[e].vertices;
      if (!free[a] && !free[b]) continue;
      const Vec3 d = positions[b] - positions[a];
      const double length = norm(d);
      if (length < 1e-12) continue;
      const double share = free[a] && free[b] ? 0.5 : 1;
      const Vec3 correction = share * (1 - rest.edge_length()[e] / length) * d;
      shift[a] += correction;
      shift[b] += -correction;
    }
    for (std::size_t v = 0; v < free.size(); ++v) {
      if (free[v]) positions[v] += 1.0 / edge_count[v] * shift[v];
    }
    if (body != nullptr && pass % passes_between_pushes == 0) push_vertices(free, *body, clearance, positions);
  }
}

void push_out(const RestMesh& rest, const std::vector<bool>& free, const Body& body, double clearance,
              std::vector<Vec3>& positions) {
  constexpr int most_passes = 12;
  const auto push_all_of = [&](const auto& vertices) {
    Vec3 middle;
    for (const int v : vertices) middle += positions[v];
    middle = middle / static_cast<double>(vertices.size());
    const auto surface = body.nearest(middle, 0);
    if (!surface || surface->distance >= 0) return false;
    bool moved = false;
    for (const int v : vertices) {
      if (!free[v]) continue;
      positions[v] += (0.2 * clearance - surface->distance) * surface->normal;
      moved = true;
    }
    return moved;
  };
  const std::vector<Vec3> before = positions;
  push_vertices(free, body, clearance, positions);
  for (int pass = 0; pass < most_passes; ++pass) {
    bool moved = false;
    for (const SMesh::Edge& edge : rest.cloth().edges) moved = push_all_of(edge.vertices) || moved;
    for (const ClothTriangle& triangle : rest.cloth().triangles) moved = push_all_of(triangle.vertices) || moved;
    if (!moved) break;
    push_vertices(free, body, 0.5 * clearance, positions);
  }
  if (intersecting_triangle_pairs(rest.cloth(), positions) > intersecting_triangle_pairs(rest.cloth(), before)) {
    positions = before;
  }
}

}  // namespace toile
