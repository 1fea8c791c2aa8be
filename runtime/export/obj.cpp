// Wavefront OBJ: one vertex a sewn vertex, so that the surface is whole; texture coordinates and normals a P-vertex.
#include <fmt/format.h>

#include <iterator>
#include <string>

#include "runtime/export/export.hpp"
#include "runtime/export/split_surface.hpp"

namespace toile {

namespace {

/// A name as one word: OBJ ends names at white space.
std::string word(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  }
  return name.empty() ? "unnamed" : name;
}

/// Single precision carries 0.1 um at a metre; the sum takes the sign off a negative zero.
float single(double value) {
  return static_cast<float>(value) + 0.0F;
}

}  // namespace

std::string obj(const DrapedGarment& draped) {
  const SewnMesh& mesh = *draped.mesh;
  const SplitSurface surface = split_surface(mesh, draped.drape->positions);
  std::string text = "# metres, z up; vt: warp and weft in metres\n";
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "o {}\n", word(draped.garment->name));
  for (const Vec3& p : draped.drape->positions) {
    fmt::format_to(out, "v {} {} {}\n", single(p.x), single(p.y), single(p.z));
  }
  for (const Vec2& uv : surface.uv) fmt::format_to(out, "vt {} {}\n", single(uv.x), single(uv.y));
  for (const Vec3& n : surface.normals) {
    fmt::format_to(out, "vn {} {} {}\n", single(n.x), single(n.y), single(n.z));
  }
  fmt::format_to(out, "usemtl {}\n", word(draped.garment->textile.name));
  PieceId piece = -1;
  for (std::size_t t = 0; t < mesh.p.triangles.size(); ++t) {
    if (mesh.p.piece_of_triangle[t] != piece) {
      piece = mesh.p.piece_of_triangle[t];
      fmt::format_to(out, "g {}\n", word(draped.garment->pieces[static_cast<std::size_t>(piece)].name));
    }
    text += 'f';
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int vertex = mesh.s.triangles[t][corner] + 1;
      const int point = mesh.p.triangles[t][corner] + 1;
      fmt::format_to(out, " {}/{}/{}", vertex, point, point);
    }
    text += '\n';
  }
  return text;
}

}  // namespace toile
