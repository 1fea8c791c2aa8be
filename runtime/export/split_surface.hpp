// The draped surface opened along its seams: a vertex for every P-vertex, so that each has one place in warp and weft.
// What formats with one index a vertex (PLY, glTF) need; formats with several take its parts.
#pragma once

#include <array>
#include <vector>

#include "compiler/smesh/smesh.hpp"
#include "runtime/export/export.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile {

struct SplitSurface {
  std::vector<Vec3> positions;                // [m]
  std::vector<Vec3> normals;                  // unit, towards the right side of the vertex's own piece
  std::vector<Vec2> uv;                       // [m] (warp, weft)
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise seen from the right side
};

SplitSurface split_surface(const SewnMesh& mesh, const std::vector<Vec3>& positions);

/// Normals of the sewn surface, one a P-vertex: the mean over all triangles about the sewn vertex, weighted by their
/// angle there, so that shading runs smoothly across a seam. Where a seam turns the cloth over (a Moebius strip) each
/// side keeps its own right side; where three sheets or more meet at an edge the normals break there.
std::vector<Vec3> smooth_normals(const SewnMesh& mesh, const std::vector<Vec3>& positions);

/// The mean of a triangle's value about each P-vertex, weighted by area in the P-mesh. It does not cross seams, beyond
/// which warp and weft run elsewhere.
std::vector<double> at_points(const std::vector<double>& of_triangle, const PMesh& mesh);

/// Triangles and points of one piece: both are contiguous in the P-mesh.
struct PieceRange {
  int first_point = 0, points = 0;
  int first_triangle = 0, triangles = 0;
};
std::vector<PieceRange> piece_ranges(const PMesh& mesh, std::size_t pieces);

}  // namespace toile
