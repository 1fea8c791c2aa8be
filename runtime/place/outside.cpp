#include "runtime/place/outside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>

namespace toile {
namespace {

constexpr int lifting_passes = 4;
constexpr int smoothing_passes = 3;
constexpr double farthest_out = 0.5;  // [m] from the body that cloth starts
constexpr double most_beyond = 0.12;  // [m] that the inner layer is looked for beyond the outer one
constexpr double same_limb = 0.7;     // of a way from the body that must be the shortest one there

/// Triangles by the cells of space that their boxes reach into.
class TriangleGrid {
 public:
  TriangleGrid(const Cloth& cloth, const std::vector<Vec3>& positions, const std::function<bool(int)>& counts,
               double cell)
      : cloth_(cloth), positions_(positions), cell_(cell) {
    for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
      if (!counts(cloth.triangles[t].layer)) continue;
      std::array<std::int64_t, 3> low{}, high{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::array<std::int64_t, 3> at = cell_of(positions[cloth.triangles[t].vertices[k]]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          low[axis] = k == 0 ? at[axis] : std::min(low[axis], at[axis]);
          high[axis] = k == 0 ? at[axis] : std::max(high[axis], at[axis]);
        }
      }
      for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
          for (std::int64_t z = low[2]; z <= high[2]; ++z) cells_[key({x, y, z})].push_back(static_cast<int>(t));
        }
      }
    }
  }

  /// Calls `met` with each triangle that the way from `from` along the unit vector crosses before `reach`, and how far.
  void along(Vec3 from, Vec3 direction, double reach, const std::function<void(int, double)>& met) const {
    std::vector<int> seen;
    for (double t = 0; t <= reach + cell_; t += 0.5 * cell_) {
      const auto found = cells_.find(key(cell_of(from + std::min(t, reach) * direction)));
      if (found == cells_.end()) continue;
      seen.insert(seen.end(), found->second.begin(), found->second.end());
    }
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    for (const int t : seen) {
      const std::optional<double> way = crossing(t, from, direction);
      if (way && *way >= 0 && *way <= reach) met(t, *way);
    }
  }

 private:
  std::array<std::int64_t, 3> cell_of(Vec3 p) const {
    return {std::llround(p.x / cell_), std::llround(p.y / cell_), std::llround(p.z / cell_)};
  }
  static std::int64_t key(const std::array<std::int64_t, 3>& at) {
    constexpr std::int64_t most = 1 << 20;
    return ((at[0] + most / 2) * most + (at[1] + most / 2)) * most + at[2] + most / 2;
  }
  // After Möller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997).
  std::optional<double> crossing(int triangle, Vec3 from, Vec3 direction) const {
    const auto& v = cloth_.triangles[triangle].vertices;
    const Vec3 a = positions_[v[0]], ab = positions_[v[1]] - a, ac = positions_[v[2]] - a;
    const Vec3 p = cross(direction, ac);
    const double det = dot(ab, p);
    if (std::abs(det) < 1e-15) return std::nullopt;
    const Vec3 s = from - a, q = cross(s, ab);
    const double u = dot(s, p) / det, w = dot(direction, q) / det;
    if (u < 0 || w < 0 || u + w > 1) return std::nullopt;
    return dot(ac, q) / det;
  }

  const Cloth& cloth_;
  const std::vector<Vec3>& positions_;
  double cell_;
  std::unordered_map<std::int64_t, std::vector<int>> cells_;
};

std::vector<int> layers_of_vertices(const Cloth& cloth) {
  std::vector<int> layers(static_cast<std::size_t>(cloth.vertex_count), 0);
  for (const ClothTriangle& triangle : cloth.triangles) {
    for (const int v : triangle.vertices) layers[v] = std::max(layers[v], triangle.layer);
  }
  return layers;
}

/// One layer that is to come outside of those below.
class OuterLayer {
 public:
  OuterLayer(const RestMesh& rest, const std::vector<int>& layers, int layer, const Body& body, double gap,
             std::vector<Vec3>& positions)
      : rest_(rest),
        layers_(layers),
        layer_(layer),
        body_(body),
        gap_(gap),
        positions_(positions),
        lift_(positions.size(), 0.0),
        from_body_(positions.size()) {}

  void put_outside() {
    for (int pass = 0; pass < lifting_passes; ++pass) {
      measure();
      std::ranges::fill(lift_, 0.0);
      lift_over_inner_triangles();
      lift_off_inner_vertices();
      if (std::ranges::max(lift_) <= 0) return;
      smooth();
      for (std::size_t v = 0; v < lift_.size(); ++v) {
        if (lift_[v] > 0) positions_[v] += lift_[v] * from_body_[v]->normal;
      }
    }
  }

 private:
  void measure() {
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      from_body_[v] = layers_[v] <= layer_ ? body_.nearest(positions_[v], farthest_out) : std::nullopt;
    }
  }
  /// Whether the body that a place is nearest to lies back along that way.
  bool is_of_this_limb(Vec3 at, double way) const {
    if (way < 0.005) return true;
    const auto nearest = body_.nearest(at, way);
    return nearest && nearest->distance >= same_limb * way;
  }
  void lift_over_inner_triangles() {
    const TriangleGrid inner(
        rest_.cloth(), positions_, [&](int layer) { return layer < layer_; }, rest_.mean_edge());
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (layers_[v] != layer_ || !from_body_[v]) continue;
      const SurfacePoint& surface = *from_body_[v];
      inner.along(surface.point, surface.normal, std::max(surface.distance, 0.0) + most_beyond, [&](int, double way) {
        const double missing = way + gap_ - surface.distance;
        if (missing <= lift_[v]) return;
        if (is_of_this_limb(surface.point + way * surface.normal, way)) lift_[v] = missing;
      });
    }
  }
  void lift_off_inner_vertices() {
    const TriangleGrid outer(
        rest_.cloth(), positions_, [&](int layer) { return layer == layer_; }, rest_.mean_edge());
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (layers_[v] >= layer_ || !from_body_[v]) continue;
      const SurfacePoint& surface = *from_body_[v];
      outer.along(surface.point, surface.normal, std::max(surface.distance, 0.0) + gap_, [&](int t, double way) {
        const double missing = surface.distance + gap_ - way;
        for (const int corner : rest_.cloth().triangles[t].vertices) {
          if (from_body_[corner]) lift_[corner] = std::max(lift_[corner], missing);
        }
      });
    }
  }
  /// Neighbours of what is lifted come along, so that the cloth keeps its shape.
  void smooth() {
    for (int pass = 0; pass < smoothing_passes; ++pass) {
      const std::vector<double> before = lift_;
      for (const SMesh::Edge& edge : rest_.cloth().edges) {
        const auto [a, b] = edge.vertices;
        if (layers_[a] != layer_) continue;
        if (from_body_[a]) lift_[a] = std::max(lift_[a], 0.8 * before[b]);
        if (from_body_[b]) lift_[b] = std::max(lift_[b], 0.8 * before[a]);
      }
    }
  }

  const RestMesh& rest_;
  const std::vector<int>& layers_;
  int layer_;
  const Body& body_;
  double gap_;
  std::vector<Vec3>& positions_;
  std::vector<double> lift_;  // [m] per vertex
  std::vector<std::optional<SurfacePoint>> from_body_;
};

}  // namespace

void put_outside(const RestMesh& rest, const Body& body, double gap, std::vector<Vec3>& positions) {
  const std::vector<int> layers = layers_of_vertices(rest.cloth());
  for (int layer = 1; layer < rest.cloth().layer_count(); ++layer) {
    OuterLayer(rest, layers, layer, body, gap, positions).put_outside();
  }
}

}  // namespace toile
