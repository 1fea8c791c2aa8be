#include "runtime/mesh/cloth.hpp"

#include <algorithm>

namespace toile {

int Cloth::fabric_count() const {
  int count = 1;
  for (const ClothTriangle& triangle : triangles) count = std::max(count, triangle.fabric + 1);
  return count;
}

int Cloth::layer_count() const {
  int count = 1;
  for (const ClothTriangle& triangle : triangles) count = std::max(count, triangle.layer + 1);
  return count;
}

Cloth make_cloth(const SewnMesh& mesh) {
  Cloth cloth;
  cloth.vertex_count = mesh.s.vertex_count;
  cloth.edge_count = static_cast<int>(mesh.s.edges.size());
  cloth.edges = mesh.s.edges;
  cloth.area_of_vertex.assign(static_cast<std::size_t>(cloth.vertex_count), 0.0);
  cloth.triangles.resize(mesh.p.triangles.size());
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    ClothTriangle& triangle = cloth.triangles[t];
    triangle.vertices = mesh.s.triangles[t];
    triangle.edges = mesh.s.edge_of_corner[t];
    const auto piece = static_cast<std::size_t>(mesh.p.piece_of_triangle[t]);
    if (!mesh.p.fabric_of_piece.empty()) triangle.fabric = mesh.p.fabric_of_piece[piece];
    if (!mesh.p.layer_of_piece.empty()) triangle.layer = mesh.p.layer_of_piece[piece];
    const Vec2 warp = mesh.p.warp_of_piece[piece];
    const Vec2 weft = perpendicular(warp);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec2 point = mesh.p.points[static_cast<std::size_t>(mesh.p.triangles[t][corner])];
      triangle.uv[corner] = {dot(point, warp), dot(point, weft)};
    }
    const double area = 0.5 * cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0]);
    for (const int vertex : triangle.vertices) cloth.area_of_vertex[static_cast<std::size_t>(vertex)] += area / 3;
    cloth.area += area;
  }
  return cloth;
}

}  // namespace toile
