#include "compiler/smesh/glue.hpp"

#include <algorithm>
#include <tuple>

#include "compiler/smesh/disjoint_sets.hpp"

namespace toile {
namespace {

void unify_vertices(const PMesh& mesh, SMesh& s) {
  DisjointSets sets(mesh.points.size());
  for (const auto& runs : mesh.sewn) {
    for (const PMesh::SewnRun& run : runs) {
      for (std::size_t i = 0; i < run.first.size(); ++i) sets.unite(run.first[i], run.second[i]);
    }
  }
  s.s_of_p.assign(mesh.points.size(), -1);
  for (int p = 0; p < static_cast<int>(mesh.points.size()); ++p) {
    const int root = sets.find(p);  // the smallest of its set, so numbered already or p itself
    if (root == p) {
      s.s_of_p[p] = s.vertex_count++;
      s.p_of_s.emplace_back();
    }
    s.s_of_p[p] = s.s_of_p[root];
    s.p_of_s[s.s_of_p[p]].push_back(p);
  }
}

void list_edges(SMesh& s) {
  struct Half {
    int low, high, triangle, corner;
    auto operator<=>(const Half&) const = default;  // NOLINT(modernize-use-nullptr): taken for one by clang-tidy 14
  };
  std::vector<Half> halves;
  halves.reserve(3 * s.triangles.size());
  for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(s.triangles[t][(c + 1) % 3], s.triangles[t][(c + 2) % 3]);
      halves.push_back({low, high, t, c});
    }
  }
  std::sort(halves.begin(), halves.end());
  s.edge_of_corner.assign(s.triangles.size(), {-1, -1, -1});
  for (const Half& h : halves) {
    if (s.edges.empty() || s.edges.back().vertices != std::array{h.low, h.high}) {
      s.edges.push_back({{h.low, h.high}, {}, -1});
    }
    s.edges.back().wings.push_back({h.triangle, h.corner});
    s.edge_of_corner[h.triangle][h.corner] = static_cast<int>(s.edges.size()) - 1;
  }
}

void mark_seams(const PMesh& mesh, SMesh& s) {
  for (int seam = 0; seam < static_cast<int>(mesh.sewn.size()); ++seam) {
    for (const PMesh::SewnRun& run : mesh.sewn[seam]) {
      for (std::size_t i = 0; i + 1 < run.first.size(); ++i) {
        const auto [low, high] = std::minmax(s.s_of_p[run.first[i]], s.s_of_p[run.first[i + 1]]);
        const std::array<int, 2> ends{low, high};
        const auto edge = std::lower_bound(s.edges.begin(), s.edges.end(), ends,
                                           [](const SMesh::Edge& e, const auto& v) { return e.vertices < v; });
        if (edge != s.edges.end() && edge->vertices == ends && edge->seam < 0) edge->seam = seam;
      }
    }
  }
}

}  // namespace

SMesh glue(const PMesh& mesh) {
  SMesh s;
  unify_vertices(mesh, s);
  s.triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) s.triangles.push_back({s.s_of_p[a], s.s_of_p[b], s.s_of_p[c]});
  list_edges(s);
  mark_seams(mesh, s);
  return s;
}

}  // namespace toile
