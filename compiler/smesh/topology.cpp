#include "compiler/smesh/topology.hpp"

#include <algorithm>

#include "compiler/smesh/disjoint_sets.hpp"

namespace toile {
namespace {

/// Corners of triangles; those that share an edge with two wings at their vertex are one sheet.
class Sheets {
 public:
  explicit Sheets(const SMesh& mesh) : mesh_(mesh), sets_(3 * mesh.triangles.size()) {
    for (const SMesh::Edge& edge : mesh.edges) {
      if (edge.wings.size() != 2) continue;
      for (const int vertex : edge.vertices)
        sets_.unite(corner_at(edge.wings[0], vertex), corner_at(edge.wings[1], vertex));
    }
  }

  /// The sheet in which an edge's wing meets a vertex.
  int at(SMesh::Wing wing, int vertex) { return sets_.find(corner_at(wing, vertex)); }
  int of_corner(int triangle, int corner) { return sets_.find(3 * triangle + corner); }

 private:
  int corner_at(SMesh::Wing wing, int vertex) const {
    const int next = (wing.corner + 1) % 3;
    return 3 * wing.triangle + (mesh_.triangles[wing.triangle][next] == vertex ? next : (wing.corner + 2) % 3);
  }

  const SMesh& mesh_;
  DisjointSets sets_;
};

void find_components(SMesh& mesh) {
  DisjointSets sets(static_cast<std::size_t>(mesh.vertex_count));
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.unite(a, b);
    sets.unite(b, c);
  }
  mesh.component_of_vertex.assign(mesh.vertex_count, -1);
  for (int v = 0; v < mesh.vertex_count; ++v) {
    const int root = sets.find(v);
    mesh.component_of_vertex[v] = root == v ? mesh.topology.components++ : mesh.component_of_vertex[root];
  }
}

int count_boundary_loops(const SMesh& mesh, Sheets& sheets) {
  std::vector<int> free_edges;
  for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e) {
    if (mesh.edges[e].wings.size() == 1) free_edges.push_back(e);
  }
  DisjointSets loops(free_edges.size());
  std::vector<int> met(3 * mesh.triangles.size(), -1);  // the free edge met at a sheet
  for (int i = 0; i < static_cast<int>(free_edges.size()); ++i) {
    const SMesh::Edge& edge = mesh.edges[free_edges[i]];
    for (const int vertex : edge.vertices) {
      int& other = met[sheets.at(edge.wings[0], vertex)];
      if (other < 0) {
        other = i;
      } else {
        loops.unite(i, other);
      }
    }
  }
  int count = 0;
  for (int i = 0; i < static_cast<int>(free_edges.size()); ++i) count += loops.find(i) == i;
  return count;
}

/// Whether a wing's triangle runs along the edge from its smaller to its larger vertex.
bool upward(const SMesh& mesh, const SMesh::Edge& edge, SMesh::Wing wing) {
  return mesh.triangles[wing.triangle][(wing.corner + 1) % 3] == edge.vertices[0];
}

bool is_orientable(const SMesh& mesh) {
  // Twice the triangles: t as it is and turned over. An orientable surface keeps the two apart.
  const int n = static_cast<int>(mesh.triangles.size());
  DisjointSets sets(2 * mesh.triangles.size());
  for (const SMesh::Edge& edge : mesh.edges) {
    if (edge.wings.size() != 2) continue;
    const int a = edge.wings[0].triangle, b = edge.wings[1].triangle;
    const bool turned = upward(mesh, edge, edge.wings[0]) == upward(mesh, edge, edge.wings[1]);
    sets.unite(a, turned ? b + n : b);
    sets.unite(a + n, turned ? b : b + n);
  }
  for (int t = 0; t < n; ++t) {
    if (sets.find(t) == sets.find(t + n)) return false;
  }
  return true;
}

bool is_manifold(const SMesh& mesh, Sheets& sheets) {
  const bool branches =
      std::any_of(mesh.edges.begin(), mesh.edges.end(), [](const SMesh::Edge& e) { return e.wings.size() > 2; });
  if (branches) return false;
  std::vector<int> sheet_of_vertex(mesh.vertex_count, -1);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      int& known = sheet_of_vertex[mesh.triangles[t][c]];
      const int sheet = sheets.of_corner(t, c);
      if (known >= 0 && known != sheet) return false;
      known = sheet;
    }
  }
  return true;
}

}  // namespace

void survey(SMesh& mesh) {
  Topology& topology = mesh.topology;
  topology = {};
  topology.vertices = mesh.vertex_count;
  topology.edges = static_cast<int>(mesh.edges.size());
  topology.triangles = static_cast<int>(mesh.triangles.size());
  topology.euler = topology.vertices - topology.edges + topology.triangles;
  Sheets sheets(mesh);
  find_components(mesh);
  topology.boundary_loops = count_boundary_loops(mesh, sheets);
  topology.orientable = is_orientable(mesh);
  topology.manifold = is_manifold(mesh, sheets);
}

}  // namespace toile
