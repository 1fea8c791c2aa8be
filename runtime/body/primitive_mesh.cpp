#include "runtime/body/primitive_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace toile {
namespace {

constexpr double facet_length = 0.008;  // [m] length of edges aimed at

int divisions(double length, int least, int most) {
  return std::clamp(static_cast<int>(std::ceil(length / facet_length)), least, most);
}

// Coordinates along one axis of a rounded box, as (core coordinate, slope of the normal): first the rounding, then the
// flat, then the other rounding.
struct Station {
  double core;
  double slope;  // tangent of the normal's angle against the face's
};
std::vector<Station> stations(double half, int flats, int rounds) {
  std::vector<Station> list;
  list.reserve(static_cast<std::size_t>(flats) + 2 * rounds + 1);
  for (int i = 0; i < rounds; ++i) {
    list.push_back({-half, -std::tan(0.25 * std::numbers::pi * (rounds - i) / rounds)});
  }
  const int n = half > 0 ? flats : 0;
  for (int i = 0; i <= n; ++i) list.push_back({n == 0 ? 0 : half * (2.0 * i / n - 1), 0});
  for (int i = 1; i <= rounds; ++i) list.push_back({half, std::tan(0.25 * std::numbers::pi * i / rounds)});
  return list;
}

// A cube's lattice inflated: each of the six faces is a grid of stations, shared along the edges.
class BoxMesh {
 public:
  BoxMesh(const RoundShape& shape, Vec3 half) : shape_(shape), half_{half.x, half.y, half.z} {
    const bool is_ball = half.x + half.y + half.z <= 0;
    const int rounds = is_ball ? std::max(8, divisions(0.25 * std::numbers::pi * shape.rounding, 8, 16)) : 3;
    for (int axis = 0; axis < 3; ++axis) axes_[axis] = stations(half_[axis], divisions(2 * half_[axis], 4, 24), rounds);
  }

  Body::Surface build() {
    for (int axis = 0; axis < 3; ++axis) {
      add_face(axis, true);
      add_face(axis, false);
    }
    return std::move(surface_);
  }

 private:
  int last(int axis) const { return static_cast<int>(axes_[axis].size()) - 1; }

  int vertex(const std::array<int, 3>& at, int axis, bool positive) {
    const auto [entry, is_new] = index_.emplace(at, static_cast<int>(surface_.points.size()));
    if (!is_new) return entry->second;
    double normal[3], core[3];
    for (int k = 0; k < 3; ++k) {
      normal[k] = k == axis ? (positive ? 1 : -1) : axes_[k][at[k]].slope;
      core[k] = k == axis ? (positive ? half_[k] : -half_[k]) : axes_[k][at[k]].core;
    }
    const Vec3 n = normalized({normal[0], normal[1], normal[2]});
    surface_.points.push_back(shape_.centre + Vec3{core[0], core[1], core[2]} + shape_.rounding * n);
    return entry->second;
  }

  void add_face(int axis, bool positive) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < last(u); ++i) {
      for (int j = 0; j < last(v); ++j) {
        const auto corner = [&](int di, int dj) {
          std::array<int, 3> at{};
          at[axis] = positive ? last(axis) : 0;
          at[u] = i + di;
          at[v] = j + dj;
          return vertex(at, axis, positive);
        };
        const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
        if (positive) {
          surface_.triangles.push_back({a, b, c});
          surface_.triangles.push_back({a, c, d});
        } else {
          surface_.triangles.push_back({a, c, b});
          surface_.triangles.push_back({a, d, c});
        }
      }
    }
  }

  const RoundShape& shape_;
  std::array<double, 3> half_;
  std::array<std::vector<Station>, 3> axes_;
  std::map<std::array<int, 3>, int> index_;
  Body::Surface surface_;
};

// The outline of a rounded cylinder, from its top to its bottom.
struct OutlinePoint {
  double radius;
  double height;
};
std::vector<OutlinePoint> cylinder_outline(const CylinderCore& core, double rounding) {
  constexpr int rounds = 6;
  std::vector<OutlinePoint> outline;
  const int rings = divisions(core.radius, 2, 24);
  for (int i = 1; i < rings; ++i) outline.push_back({core.radius * i / rings, core.half_length + rounding});
  for (int i = 0; i <= rounds; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / rounds;
    outline.push_back({core.radius + rounding * std::sin(angle), core.half_length + rounding * std::cos(angle)});
  }
  const int rows = core.half_length > 0 ? divisions(2 * core.half_length, 1, 60) : 0;
  for (int i = 1; i < rows; ++i) {
    outline.push_back({core.radius + rounding, core.half_length * (1 - 2.0 * i / rows)});
  }
  const int upper = static_cast<int>(outline.size());
  for (int i = upper - 1; i >= 0; --i) {
    const OutlinePoint p = outline[i];
    const bool is_own_image = rows == 0 ? i == upper - 1 : p.height < core.half_length - 1e-12;
    if (!is_own_image) outline.push_back({p.radius, -p.height});
  }
  return outline;
}

Body::Surface triangulate_cylinder(const RoundShape& shape, const CylinderCore& core) {
  const std::vector<OutlinePoint> outline = cylinder_outline(core, shape.rounding);
  const int columns = divisions(2 * std::numbers::pi * core.radius, 48, 128);
  const auto place = [&](double x, double y, double height) {
    return shape.centre + (core.upright ? Vec3{x, y, height} : Vec3{height, x, y});
  };
  Body::Surface surface;
  for (const OutlinePoint p : outline) {
    for (int i = 0; i < columns; ++i) {
      const double angle = 2 * std::numbers::pi * i / columns;
      surface.points.push_back(place(p.radius * std::sin(angle), -p.radius * std::cos(angle), p.height));
    }
  }
  const int rows = static_cast<int>(outline.size());
  const int top = static_cast<int>(surface.points.size());
  surface.points.push_back(place(0, 0, core.half_length + shape.rounding));
  surface.points.push_back(place(0, 0, -core.half_length - shape.rounding));
  for (int i = 0; i < columns; ++i) {
    const int j = (i + 1) % columns;
    surface.triangles.push_back({i, j, top});
    for (int r = 0; r + 1 < rows; ++r) {
      const int above = r * columns, below = above + columns;
      surface.triangles.push_back({below + i, below + j, above + j});
      surface.triangles.push_back({below + i, above + j, above + i});
    }
    const int lowest = (rows - 1) * columns;
    surface.triangles.push_back({lowest + j, lowest + i, top + 1});
  }
  return surface;
}

}  // namespace

Body::Surface triangulate(const RoundShape& shape) {
  if (const auto* box = std::get_if<BoxCore>(&shape.core)) return BoxMesh(shape, box->half).build();
  return triangulate_cylinder(shape, std::get<CylinderCore>(shape.core));
}

Body::Surface triangulate_plane(double height) {
  constexpr double half = 50;
  return {{{-half, -half, height}, {half, -half, height}, {half, half, height}, {-half, half, height}},
          {{0, 1, 2}, {0, 2, 3}}};
}

}  // namespace toile
