#include <algorithm>

#include "compiler/pmesh/mesher.hpp"
#include "compiler/smesh/glue.hpp"
#include "compiler/smesh/smesh.hpp"
#include "compiler/smesh/strictness.hpp"
#include "compiler/smesh/topology.hpp"
#include "compiler/smesh/worn.hpp"

namespace toile {
namespace {

constexpr int most_sewing_rounds = 16;

/// Triangles at each S-vertex.
std::vector<int> star_sizes(const SMesh& s) {
  std::vector<int> sizes(s.vertex_count, 0);
  for (const auto& t : s.triangles) {
    for (const int v : t) ++sizes[v];
  }
  return sizes;
}

/// A vertex inside a surface needs three triangles about it; the tip of a cone made of a narrow sector has one, however
/// fine the mesh. Returns whether there is a new wish.
bool open_fan(const SMesh& s, int vertex, GarmentMesher& mesher) {
  bool any = false;
  const auto& points = s.p_of_s[vertex];
  const int sectors = (2 + static_cast<int>(points.size())) / static_cast<int>(points.size());
  for (const int p : points) any |= sectors > 1 && mesher.is_on_outline(p) && mesher.want_fan(p, sectors);
  return any;
}

/// Points at which a seam turns back on its own piece: the tips of darts, cones and zips, sewn to themselves.
std::vector<int> tips(const PMesh& p) {
  std::vector<int> found;
  for (const auto& runs : p.sewn) {
    for (const PMesh::SewnRun& run : runs) {
      for (const std::size_t i : {std::size_t{0}, run.first.size() - 1}) {
        const std::size_t next = i == 0 ? 1 : i - 1;
        if (run.first[i] == run.second[i] && run.first[next] != run.second[next]) found.push_back(run.first[i]);
      }
    }
  }
  return found;
}

bool open_fan_nearby(const SewnMesh& mesh, const Breach& breach, GarmentMesher& mesher) {
  constexpr double kNearby = 4;  // lengths of the edge
  const Vec2 a = mesh.p.points[breach.points[0]], b = mesh.p.points[breach.points[1]];
  bool any = false;
  for (const int tip : tips(mesh.p)) {
    const bool near = mesh.p.piece_of_point[tip] == mesh.p.piece_of_point[breach.points[0]] &&
                      distance(mesh.p.points[tip], (a + b) / 2) < kNearby * distance(a, b);
    any |= near && mesher.want_fan(tip, 3);
  }
  return any;
}

/// A corner of a piece that is sewn upon another is cut off by an edge which the other may have as well, however fine
/// the meshes are; two triangles at the corner have no such edge.
bool open_corner(const SewnMesh& mesh, int point, GarmentMesher& mesher) {
  const auto& points = mesh.s.p_of_s[mesh.s.s_of_p[point]];
  const bool on_line = std::any_of(points.begin(), points.end(), [&](int p) { return mesher.is_on_line(p); });
  if (!on_line || !mesher.is_on_outline(point)) return false;
  const auto at_point = [&](const auto& t) { return t[0] == point || t[1] == point || t[2] == point; };
  const auto triangles = std::count_if(mesh.p.triangles.begin(), mesh.p.triangles.end(), at_point);
  return triangles == 1 && mesher.want_fan(point, 2);
}

void mend(const SewnMesh& mesh, const std::vector<Breach>& breaches, GarmentMesher& mesher) {
  const std::vector<int> stars = star_sizes(mesh.s);
  for (const Breach& breach : breaches) {
    const auto [a, b] = breach.points;
    bool fanned = !breach.on_outline && open_fan_nearby(mesh, breach, mesher);
    for (const int facing : breach.facing) {
      const int vertex = mesh.s.s_of_p[facing];
      fanned |= stars[vertex] < 3 && !breach.on_outline && open_fan(mesh.s, vertex, mesher);
      fanned |= open_corner(mesh, facing, mesher);
    }
    if (fanned) continue;
    if (breach.on_outline) {
      mesher.want_side_split(a, b);
    } else {
      const Vec2 p = mesh.p.points[a], q = mesh.p.points[b];
      const double length = distance(p, q);
      mesher.want_smaller(mesh.p.piece_of_point[a], (p + q) / 2, length, length / 2);
    }
  }
}

}  // namespace

SewnMesh sew(const Garment& garment, const PMeshOptions& options) {
  GarmentMesher mesher(garment, options);
  SewnMesh mesh;
  for (int round = 0; round < most_sewing_rounds; ++round) {
    mesh.p = mesher.mesh();
    mesh.s = glue(garment, mesh.p);
    const std::vector<Breach> breaches = find_breaches(mesh.p, mesh.s);
    if (breaches.empty()) break;
    mend(mesh, breaches, mesher);
  }
  survey(mesh.s);
  mesh.s.worn = find_worn_lines(garment, mesh.p, mesh.s);
  return mesh;
}

}  // namespace toile
