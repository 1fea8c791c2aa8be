#include "compiler/smesh/strictness.hpp"

#include <algorithm>
#include <utility>

#include "compiler/smesh/disjoint_sets.hpp"

namespace toile {
namespace {

using Pair = std::array<int, 2>;

Pair sorted(int a, int b) {
  return a < b ? Pair{a, b} : Pair{b, a};
}

/// The P-mesh's edges, those that a seam joins in one set.
class PlaneEdges {
 public:
  explicit PlaneEdges(const PMesh& mesh) : edges_(edges_of(mesh)), sets_(edges_.size()) {
    for (const auto& runs : mesh.sewn) {
      for (const PMesh::SewnRun& run : runs) {
        for (std::size_t i = 0; i + 1 < run.first.size(); ++i) {
          const int a = find(sorted(run.first[i], run.first[i + 1]));
          const int b = find(sorted(run.second[i], run.second[i + 1]));
          if (a >= 0 && b >= 0) sets_.unite(a, b);
        }
      }
    }
  }

  int find(Pair ends) const {
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), Edge{ends, 0},
                                     [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
    return at != edges_.end() && at->ends == ends ? static_cast<int>(at - edges_.begin()) : -1;
  }
  int set(int edge) { return sets_.find(edge); }
  bool on_outline(int edge) const { return edges_[edge].triangles == 1; }

 private:
  struct Edge {
    Pair ends{};
    int triangles = 0;
  };

  static std::vector<Edge> edges_of(const PMesh& mesh) {
    std::vector<Pair> pairs;
    pairs.reserve(3 * mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
      for (int c = 0; c < 3; ++c) pairs.push_back(sorted(t[(c + 1) % 3], t[(c + 2) % 3]));
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<Edge> edges;
    for (const Pair& ends : pairs) {
      if (edges.empty() || edges.back().ends != ends) edges.push_back({ends, 0});
      ++edges.back().triangles;
    }
    return edges;
  }

  std::vector<Edge> edges_;
  DisjointSets sets_;
};

class Search {
 public:
  Search(const PMesh& p, const SMesh& s) : p_(p), s_(s), plane_(p) {}

  std::vector<Breach> run() {
    for (const SMesh::Edge& edge : s_.edges) {
      if (edge.vertices[0] == edge.vertices[1] || stands_for_several(edge)) add(edge.wings);
    }
    if (breaches_.empty()) add_equal_triangles();
    return std::move(breaches_);
  }

 private:
  int plane_edge(SMesh::Wing w) const {
    const auto& t = p_.triangles[w.triangle];
    return plane_.find(sorted(t[(w.corner + 1) % 3], t[(w.corner + 2) % 3]));
  }

  bool stands_for_several(const SMesh::Edge& edge) {
    const int set = plane_.set(plane_edge(edge.wings.front()));
    return std::any_of(edge.wings.begin(), edge.wings.end(),
                       [&](SMesh::Wing w) { return plane_.set(plane_edge(w)) != set; });
  }

  /// Of several edges those inside the pieces are made finer, and those on outlines only where there are no others.
  void add(const std::vector<SMesh::Wing>& wings) {
    const bool inside =
        std::any_of(wings.begin(), wings.end(), [&](SMesh::Wing w) { return !plane_.on_outline(plane_edge(w)); });
    for (const SMesh::Wing w : wings) {
      const auto& t = p_.triangles[w.triangle];
      const int edge = plane_edge(w);
      if (plane_.on_outline(edge) == inside) continue;
      const std::array<int, 2> points = sorted(t[(w.corner + 1) % 3], t[(w.corner + 2) % 3]);
      if (breaches_.empty() || breaches_.back().points != points) breaches_.push_back({points, {}, !inside});
      breaches_.back().facing.push_back(t[w.corner]);
    }
  }

  void add_equal_triangles() {
    std::vector<std::pair<std::array<int, 3>, int>> keys;
    for (int t = 0; t < static_cast<int>(s_.triangles.size()); ++t) {
      auto key = s_.triangles[t];
      std::sort(key.begin(), key.end());
      keys.emplace_back(key, t);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 1; i < keys.size(); ++i) {
      if (keys[i].first != keys[i - 1].first) continue;
      for (int c = 0; c < 3; ++c) add({{keys[i].second, c}});
      for (int c = 0; c < 3; ++c) add({{keys[i - 1].second, c}});
    }
  }

  const PMesh& p_;
  const SMesh& s_;
  PlaneEdges plane_;
  std::vector<Breach> breaches_;
};

}  // namespace

std::vector<Breach> find_breaches(const PMesh& p, const SMesh& s) {
  return Search(p, s).run();
}

}  // namespace toile
