#include "runtime/export/split_surface.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/mesh/index.hpp"

namespace toile {

namespace {

/// Whether the triangle walks the edge opposite to `corner` from its smaller vertex to its larger.
bool walks_upwards(const std::array<int, 3>& triangle, int corner) {
  return triangle[index((corner + 1) % 3)] < triangle[index((corner + 2) % 3)];
}

/// The triangle's normal times its angle at the corner; nothing where it has no area.
Vec3 weighted_normal(const std::array<int, 3>& triangle, std::size_t corner, const std::vector<Vec3>& positions) {
  const Vec3 here = positions[index(triangle[corner])];
  const Vec3 first = positions[index(triangle[(corner + 1) % 3])] - here;
  const Vec3 second = positions[index(triangle[(corner + 2) % 3])] - here;
  const Vec3 normal = cross(first, second);
  const double size = norm(normal);
  if (!(size > 0)) return {};
  return std::atan2(size, dot(first, second)) / size * normal;
}

/// A triangle about a vertex, and whether its right side agrees (+1) or not (-1) with that of the one we came from.
struct Seen {
  int triangle = 0;
  int sign = 1;
};

/// The triangles about an S-vertex that can be reached from `start` across edges of two triangles.
std::vector<Seen> fan(const SMesh& mesh, int vertex, int start) {
  std::vector<Seen> seen{{start, 1}};
  for (std::size_t next = 0; next < seen.size(); ++next) {
    const auto [triangle, sign] = seen[next];
    for (int corner = 0; corner < 3; ++corner) {
      if (mesh.triangles[index(triangle)][index(corner)] == vertex) continue;
      const SMesh::Edge& edge = mesh.edges[index(mesh.edge_of_corner[index(triangle)][index(corner)])];
      if (edge.wings.size() != 2) continue;
      const SMesh::Wing& other = edge.wings[edge.wings[0].triangle == triangle ? 1 : 0];
      const bool known = std::any_of(seen.begin(), seen.end(), [&](Seen s) { return s.triangle == other.triangle; });
      if (known) continue;
      const bool turned = walks_upwards(mesh.triangles[index(triangle)], corner) ==
                          walks_upwards(mesh.triangles[index(other.triangle)], other.corner);
      seen.push_back({other.triangle, turned ? -sign : sign});
    }
  }
  return seen;
}

}  // namespace

std::vector<Vec3> smooth_normals(const SewnMesh& mesh, const std::vector<Vec3>& positions) {
  std::vector<Vec3> normals(mesh.p.points.size());
  std::vector<bool> done(mesh.p.points.size(), false);
  for (std::size_t t = 0; t < mesh.p.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t point = index(mesh.p.triangles[t][corner]);
      if (done[point]) continue;
      done[point] = true;
      const int vertex = mesh.s.triangles[t][corner];
      Vec3 sum;
      for (const Seen& seen : fan(mesh.s, vertex, static_cast<int>(t))) {
        const std::array<int, 3>& about = mesh.s.triangles[index(seen.triangle)];
        const auto at = static_cast<std::size_t>(std::find(about.begin(), about.end(), vertex) - about.begin());
        sum += static_cast<double>(seen.sign) * weighted_normal(about, at, positions);
      }
      const double size = norm(sum);
      normals[point] = size > 0 ? sum / size : Vec3{0, 0, 1};
    }
  }
  for (std::size_t point = 0; point < normals.size(); ++point) {
    if (!done[point]) normals[point] = {0, 0, 1};
  }
  return normals;
}

SplitSurface split_surface(const SewnMesh& mesh, const std::vector<Vec3>& positions) {
  SplitSurface surface;
  surface.triangles = mesh.p.triangles;
  surface.normals = smooth_normals(mesh, positions);
  surface.positions.reserve(mesh.p.points.size());
  surface.uv.reserve(mesh.p.points.size());
  for (std::size_t point = 0; point < mesh.p.points.size(); ++point) {
    const Vec2 warp = mesh.p.warp_of_piece[index(mesh.p.piece_of_point[point])];
    surface.positions.push_back(positions[index(mesh.s.s_of_p[point])]);
    surface.uv.push_back({dot(mesh.p.points[point], warp), dot(mesh.p.points[point], perpendicular(warp))});
  }
  return surface;
}

std::vector<double> at_points(const std::vector<double>& of_triangle, const PMesh& mesh) {
  std::vector<double> sum(mesh.points.size(), 0.0);
  std::vector<double> weight(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size() && t < of_triangle.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const Vec2 origin = mesh.points[index(a)];
    const double area = 0.5 * std::abs(cross(mesh.points[index(b)] - origin, mesh.points[index(c)] - origin));
    for (const int point : {a, b, c}) {
      sum[index(point)] += area * of_triangle[t];
      weight[index(point)] += area;
    }
  }
  for (std::size_t point = 0; point < sum.size(); ++point) {
    if (weight[point] > 0) sum[point] /= weight[point];
  }
  return sum;
}

std::vector<PieceRange> piece_ranges(const PMesh& mesh, std::size_t pieces) {
  std::vector<PieceRange> ranges(pieces);
  for (std::size_t point = mesh.points.size(); point-- > 0;) {
    PieceRange& range = ranges[index(mesh.piece_of_point[point])];
    range.first_point = static_cast<int>(point);
    ++range.points;
  }
  for (std::size_t triangle = mesh.triangles.size(); triangle-- > 0;) {
    PieceRange& range = ranges[index(mesh.piece_of_triangle[triangle])];
    range.first_triangle = static_cast<int>(triangle);
    ++range.triangles;
  }
  return ranges;
}

}  // namespace toile
