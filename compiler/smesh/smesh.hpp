// The S-mesh: the sewn surface. Vertices and edges of the P-mesh that are sewn together are one; triangles stay as they
// are.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compiler/pmesh/pmesh.hpp"

namespace toile {

struct Topology {
  int vertices = 0;
  int edges = 0;
  int triangles = 0;
  int components = 0;
  int boundary_loops = 0;
  int euler = 0;  // vertices - edges + triangles
  bool orientable = true;
  bool manifold = true;  // no edge with three triangles or more, no vertex where sheets only touch
};

struct SMesh {
  int vertex_count = 0;
  std::vector<std::array<int, 3>> triangles;  // same order and same corners as the P-mesh's

  /// An edge of the sewn surface; `wings` are its triangles, one on a free edge, two inside or at a seam, more at a
  /// T-seam or where something is sewn upon a piece. Of more the first two are bent as one cloth, and with `pairs` 2
  /// also the next two, each pair by itself.
  struct Wing {
    int triangle = 0;
    int corner = 0;  // the edge is opposite to this corner of the triangle
  };
  struct Edge {
    std::array<int, 2> vertices{};  // smaller first
    std::vector<Wing> wings;
    int seam = -1;  // index of the seam it lies on, or -1
    int pairs = 1;
    /// [rad] by which the cloth is creased there, as pleats are pressed: the angle between its normals at rest,
    /// positive for a ridge seen from the right side.
    double crease = 0;
  };
  std::vector<Edge> edges;                         // sorted by vertices
  std::vector<std::array<int, 3>> edge_of_corner;  // [triangle][corner]: the edge opposite to the corner

  std::vector<int> s_of_p;               // P-vertex to S-vertex
  std::vector<std::vector<int>> p_of_s;  // S-vertex to its P-vertices, ascending
  Topology topology;
  std::vector<int> component_of_vertex;

  /// Worn lines as S-vertices in the order of Wear::chain, with the arc length along the chain [m]; a closed one does
  /// not repeat its first vertex and `length` is that of the whole loop.
  struct WornLine {
    int wear = 0;  // index into Garment::wears
    std::vector<int> vertices;
    std::vector<double> arc;
    double length = 0;
    bool closed = false;
    /// The arc length at the middle of the edge named first: of all its parts and copies that lie together there.
    double centre = 0;
    std::vector<PieceId> pieces;  // those whose edges are named, ascending: their cloth hangs there
  };
  std::vector<WornLine> worn;
};

/// A garment and its two meshes, as the runtime takes them.
struct SewnMesh {
  PMesh p;
  SMesh s;
};

/// Meshes and sews; where sewing would break the strict simplicial complex (an edge glued onto itself, two triangles or
/// two edges with the same vertices, a triangle with a repeated vertex) the outline is divided more finely there and
/// meshed again. Nodes are added about the tips of cones, where no fineness would help. After 16 rounds, which no
/// garment of the tests needs, the mesh is handed over as it is.
SewnMesh sew(const Garment& garment, const PMeshOptions& options);

std::string emit(const SMesh& mesh, const Garment& garment);

}  // namespace toile
