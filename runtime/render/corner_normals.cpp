#include <cmath>
#include <cstddef>

#include "runtime/render/surface.hpp"

namespace toile {
namespace {

std::size_t next(std::size_t corner) {
  return (corner + 1) % 3;
}

/// A corner of a triangle in a fan, and whether its triangle is turned over against the fan's first.
struct Blade {
  std::size_t triangle, corner;
  double sign;
};

class Fans {
 public:
  Fans(const std::vector<Vec3>& points, const std::vector<PerCorner<int>>& triangles, const EdgeTable& edges,
       double crease)
      : triangles_(triangles), edges_(edges), least_cosine_(std::cos(crease)) {
    for (const auto& t : triangles) {
      const Vec3 a = points[static_cast<std::size_t>(t[0])];
      areas_.push_back(cross(points[static_cast<std::size_t>(t[1])] - a, points[static_cast<std::size_t>(t[2])] - a));
    }
  }

  std::vector<PerCorner<Vec3>> normals() const {
    std::vector<PerCorner<Vec3>> result(triangles_.size());
    std::vector<PerCorner<bool>> done(triangles_.size(), PerCorner<bool>{});
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (done[t][c]) continue;
        const std::vector<Blade> blades = fan({t, c, 1.0}, done);
        Vec3 sum;
        for (const Blade& blade : blades) sum += blade.sign * areas_[blade.triangle];
        for (const Blade& blade : blades) {
          result[blade.triangle][blade.corner] = unit(blade.sign * sum, areas_[blade.triangle]);
        }
      }
    }
    return result;
  }

 private:
  static Vec3 unit(Vec3 sum, Vec3 fallback) {
    if (norm(sum) > 0) return normalized(sum);
    return norm(fallback) > 0 ? normalized(fallback) : Vec3{0, 0, 1};
  }

  /// Both ways from the first corner over the edges at its vertex, as far as the surface goes on smoothly.
  std::vector<Blade> fan(Blade first, std::vector<PerCorner<bool>>& done) const {
    std::vector<Blade> blades{first};
    done[first.triangle][first.corner] = true;
    for (std::size_t i = 0; i < blades.size(); ++i) {
      const Blade at = blades[i];
      for (const std::size_t opposite : {next(at.corner), next(next(at.corner))}) {
        const auto across = neighbour(at, opposite);
        if (across.triangle == at.triangle || done[across.triangle][across.corner]) continue;
        done[across.triangle][across.corner] = true;
        blades.push_back(across);
      }
    }
    return blades;
  }

  /// The blade beyond the edge opposite to `opposite`, or `at` itself where the fan ends.
  Blade neighbour(const Blade& at, std::size_t opposite) const {
    const auto& wings = edges_.wings[static_cast<std::size_t>(edges_.edge_of_corner[at.triangle][opposite])];
    if (wings.size() != 2) return at;
    const auto self = static_cast<int>(3 * at.triangle + opposite);
    const auto other = static_cast<std::size_t>(wings[0] == self ? wings[1] : wings[0]);
    const std::size_t triangle = other / 3;
    const std::size_t apex = other % 3;
    if (triangle == at.triangle) return at;
    const int vertex = triangles_[at.triangle][at.corner];
    const std::size_t corner = triangles_[triangle][next(apex)] == vertex ? next(apex) : next(next(apex));
    // Neighbours that agree run along their common edge in opposite directions.
    const bool agree = triangles_[triangle][next(apex)] != triangles_[at.triangle][next(opposite)];
    const Blade across{triangle, corner, agree ? at.sign : -at.sign};
    const Vec3 a = at.sign * areas_[at.triangle];
    const Vec3 b = across.sign * areas_[triangle];
    return dot(a, b) >= least_cosine_ * norm(a) * norm(b) ? across : at;
  }

  const std::vector<PerCorner<int>>& triangles_;
  const EdgeTable& edges_;
  double least_cosine_;
  std::vector<Vec3> areas_;
};

}  // namespace

std::vector<PerCorner<Vec3>> corner_normals(const std::vector<Vec3>& points,
                                            const std::vector<PerCorner<int>>& triangles, const EdgeTable& edges,
                                            double crease) {
  return Fans(points, triangles, edges, crease).normals();
}

}  // namespace toile
