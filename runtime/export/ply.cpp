// Binary PLY: the surface opened along its seams, with what the drape found as properties of vertices.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "runtime/export/export.hpp"
#include "runtime/export/little_endian.hpp"
#include "runtime/export/split_surface.hpp"
#include "runtime/field/field.hpp"

namespace toile {

namespace {

std::string header(const std::string& garment, std::size_t vertices, std::size_t faces) {
  return fmt::format(
      "ply\n"
      "format binary_little_endian 1.0\n"
      "comment {}: metres, z up; u warp and v weft in metres; strains as ratios, shear in radians; pressure in Pa\n"
      "comment vertices are repeated along seams: those of one sewn_vertex are one\n"
      "element vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property float u\nproperty float v\n"
      "property float strain_warp\nproperty float strain_weft\nproperty float strain_shear\n"
      "property float pressure\n"
      "property int sewn_vertex\n"
      "element face {}\n"
      "property list uchar int vertex_indices\n"
      "property int piece\n"
      "end_header\n",
      garment, vertices, faces);
}

}  // namespace

std::string ply(const DrapedGarment& draped) {
  const SewnMesh& mesh = *draped.mesh;
  const SplitSurface surface = split_surface(mesh, draped.drape->positions);
  const auto values_of = [&](const char* name) { return field(name, *draped.cloth, *draped.drape).values; };
  const std::vector<double> warp = at_points(values_of("strain.warp"), mesh.p);
  const std::vector<double> weft = at_points(values_of("strain.weft"), mesh.p);
  const std::vector<double> shear = at_points(values_of("strain.shear"), mesh.p);
  const std::vector<double> pressure = values_of("contact.pressure");

  std::string name = draped.garment->name;
  std::replace(name.begin(), name.end(), '\n', ' ');
  std::string bytes = header(name, surface.positions.size(), surface.triangles.size());
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const Vec3 p = surface.positions[i];
    const Vec3 n = surface.normals[i];
    const Vec2 uv = surface.uv[i];
    const auto sewn = static_cast<std::size_t>(mesh.s.s_of_p[i]);
    const std::array<double, 12> values{p.x,  p.y,  p.z,     n.x,     n.y,      n.z,
                                        uv.x, uv.y, warp[i], weft[i], shear[i], pressure[sewn]};
    for (const double value : values) append(bytes, static_cast<float>(value));
    append(bytes, static_cast<std::int32_t>(mesh.s.s_of_p[i]));
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    bytes.push_back(3);
    for (const int point : surface.triangles[t]) append(bytes, static_cast<std::int32_t>(point));
    append(bytes, static_cast<std::int32_t>(mesh.p.piece_of_triangle[t]));
  }
  return bytes;
}

}  // namespace toile
