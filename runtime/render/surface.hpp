// A triangle surface as it is pictured: shared points, and per corner what is interpolated over a triangle.
#pragma once

#include <array>
#include <vector>

#include "compiler/curve/vec2.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile {

template <typename T>
using PerCorner = std::array<T, 3>;

struct Surface {
  std::vector<Vec3> points;
  std::vector<PerCorner<int>> triangles;
  std::vector<PerCorner<Vec3>> normals;  // unit; on the side from which the triangle is counter-clockwise
  std::vector<PerCorner<Vec2>> uv;       // [m] place in warp and weft; empty for a body
  std::vector<PerCorner<Vec3>> seam;     // [m] distance to the seams that are the triangle's sides; empty for a body
  std::vector<PerCorner<double>> value;  // of the field shown; empty without one
};

/// The edges of a triangle surface, each once, and which triangles meet there.
struct EdgeTable {
  static constexpr int kNone = -1;

  std::vector<PerCorner<int>> edge_of_corner;  // the edge opposite to the corner
  std::vector<std::array<int, 2>> vertices;    // smaller first
  std::vector<std::vector<int>> wings;         // per edge: 3 * triangle + corner, ascending

  explicit EdgeTable(const std::vector<PerCorner<int>>& triangles);
};

/// Area-weighted normals per corner, averaged over the fan of triangles about the corner's vertex. The fan ends at free
/// edges, where three triangles or more meet and where the surface turns by more than `crease` [rad]; orientation is
/// carried from triangle to triangle, so a Möbius strip is as smooth as any other.
std::vector<PerCorner<Vec3>> corner_normals(const std::vector<Vec3>& points,
                                            const std::vector<PerCorner<int>>& triangles, const EdgeTable& edges,
                                            double crease);

/// Divides every triangle into four. New points lie on cubic arcs at right angles to the corner normals (after Vlachos
/// et al., Curved PN Triangles, 2001), those of free edges on the cubic through four neighbours (Dyn, Levin & Gregory
/// 1987); old points stay. Normals are made anew.
Surface divided(const Surface& surface, double crease);

}  // namespace toile
