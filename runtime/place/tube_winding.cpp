#include "runtime/place/tube_winding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <utility>

#include "compiler/smesh/disjoint_sets.hpp"
#include "runtime/place/winding.hpp"

namespace toile {
namespace {

// Edges that the cut crosses, with their ends on its left and on its right.
using Cut = std::map<std::pair<int, int>, int>;  // both vertices in either order: +1 from left to right, -1 back

class Tube {
 public:
  Tube(const RestMesh& rest, const HangingChain& chain, const std::vector<bool>& own)
      : cloth_(rest.cloth()), chain_(chain), own_(own), on_chain_(own.size(), false) {
    for (const int v : chain.vertices) on_chain_[v] = true;
  }

  /// From between the chain's last vertex and its first to the free edge; empty where there is no way.
  std::optional<Cut> cut() const {
    if (!has_one_free_edge()) return std::nullopt;
    const int first = opening();
    if (first < 0) return std::nullopt;
    const std::vector<int> crossed = way_out(first);
    if (crossed.empty()) return std::nullopt;
    int left = chain_.vertices.back(), right = chain_.vertices.front();
    Cut cut;
    for (const int e : crossed) {
      // The next edge of a triangle has one end in common with the one before: that stays on its side.
      const auto [a, b] = cloth_.edges[e].vertices;
      if (a == left || b == left) {
        right = a == left ? b : a;
      } else {
        left = a == right ? b : a;
      }
      cut[{left, right}] = 1;
      cut[{right, left}] = -1;
    }
    return cut;
  }

 private:
  bool counts(int triangle) const {
    const auto& corners = cloth_.triangles[triangle].vertices;
    return std::all_of(corners.begin(), corners.end(), [&](int v) { return own_[v]; });
  }

  std::vector<int> triangles_of(const SMesh::Edge& edge) const {
    std::vector<int> found;
    for (const SMesh::Wing& wing : edge.wings) {
      if (counts(wing.triangle)) found.push_back(wing.triangle);
    }
    return found;
  }

  bool on_chain(const SMesh::Edge& edge) const { return on_chain_[edge.vertices[0]] && on_chain_[edge.vertices[1]]; }

  bool is_free(const SMesh::Edge& edge) const { return !on_chain(edge) && triangles_of(edge).size() == 1; }

  bool has_one_free_edge() const {
    DisjointSets joined(own_.size());
    for (const SMesh::Edge& edge : cloth_.edges) {
      if (is_free(edge)) joined.unite(edge.vertices[0], edge.vertices[1]);
    }
    int loop = -1;
    for (const SMesh::Edge& edge : cloth_.edges) {
      if (!is_free(edge)) continue;
      const int of = joined.find(edge.vertices[0]);
      if (loop >= 0 && of != loop) return false;
      loop = of;
    }
    return loop >= 0;
  }

  // The edge between the chain's last vertex and its first.
  int opening() const {
    const auto [low, high] = std::minmax(chain_.vertices.front(), chain_.vertices.back());
    for (std::size_t e = 0; e < cloth_.edges.size(); ++e) {
      if (cloth_.edges[e].vertices == std::array{low, high}) return static_cast<int>(e);
    }
    return -1;
  }

  // The edges crossed from `first` to the free edge, both included, by the fewest triangles.
  std::vector<int> way_out(int first) const {
    const std::vector<int> start = triangles_of(cloth_.edges[first]);
    if (start.size() != 1) return {};
    std::map<int, std::pair<int, int>> entered;  // each triangle by which edge, and from which triangle
    entered[start.front()] = {first, -1};
    std::queue<int> next;
    next.push(start.front());
    while (!next.empty()) {
      const int t = next.front();
      next.pop();
      for (const int e : cloth_.triangles[t].edges) {
        const SMesh::Edge& edge = cloth_.edges[e];
        if (is_free(edge)) return way_back(entered, t, e);
        if (on_chain(edge)) continue;
        for (const int other : triangles_of(edge)) {
          if (entered.try_emplace(other, e, t).second) next.push(other);
        }
      }
    }
    return {};
  }

  static std::vector<int> way_back(const std::map<int, std::pair<int, int>>& entered, int triangle, int last) {
    std::vector<int> crossed{last};
    for (int t = triangle; t >= 0; t = entered.at(t).second) crossed.push_back(entered.at(t).first);
    std::reverse(crossed.begin(), crossed.end());
    return crossed;
  }

  const Cloth& cloth_;
  const HangingChain& chain_;
  const std::vector<bool>& own_;
  std::vector<bool> on_chain_;
};

}  // namespace

std::optional<std::vector<double>> tube_winding(const RestMesh& rest, const HangingChain& chain,
                                                const std::vector<bool>& own) {
  if (chain.worn == nullptr || !chain.worn->closed || chain.vertices.size() < 3) return std::nullopt;
  const std::optional<Cut> cut = Tube(rest, chain, own).cut();
  if (!cut) return std::nullopt;
  std::vector<double> fraction(own.size(), 0.0);
  std::vector<bool> unknown = own;
  for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
    fraction[chain.vertices[i]] = chain.fractions[i];
    unknown[chain.vertices[i]] = false;
  }
  const double turn = -std::round(chain.fractions.front() - chain.fractions.back());
  const std::vector<double> added =
      harmonic_correction(rest.cloth(), unknown, std::vector<double>(own.size(), 0.0), [&](int v, int w) {
        const auto across = cut->find({v, w});
        return fraction[w] - fraction[v] + (across == cut->end() ? 0.0 : across->second * turn);
      });
  for (std::size_t v = 0; v < own.size(); ++v) fraction[v] += added[v];
  return fraction;
}

}  // namespace toile
