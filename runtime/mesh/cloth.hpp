// A sewn cloth as the runtime's mechanics take it: triangles with their own place in warp and weft, and nothing of the
// pattern.
#pragma once

#include <array>
#include <vector>

#include "compiler/curve/vec2.hpp"
#include "compiler/smesh/smesh.hpp"

namespace toile {

struct ClothTriangle {
  std::array<int, 3> vertices{};  // of the S-mesh
  std::array<int, 3> edges{};     // opposite to each vertex
  std::array<Vec2, 3> uv{};  // [m] corners in (warp, weft); right-handed for the drawn copy seen from the right side
  int fabric = 0;            // of those that the cloth is made of
  int layer = 0;             // of garments worn over each other, from the inside out
};

struct Cloth {
  int vertex_count = 0;
  int edge_count = 0;
  std::vector<ClothTriangle> triangles;
  std::vector<SMesh::Edge> edges;
  std::vector<double> area_of_vertex;  // [m2] a third of each adjoining triangle's area in the P-mesh
  double area = 0;                     // [m2]

  int fabric_count() const;
  int layer_count() const;
};

Cloth make_cloth(const SewnMesh& mesh);

}  // namespace toile
