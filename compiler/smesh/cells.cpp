#include "compiler/smesh/cells.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/pattern/region.hpp"
#include "compiler/pmesh/bundles.hpp"
#include "compiler/smesh/disjoint_sets.hpp"

namespace toile {
namespace {

double area_of_outlines(const Garment& garment) {
  double area = 0;
  for (const Piece& piece : garment.pieces) {
    for (const PieceEdge& edge : piece.edges) area += signed_area(edge.curve);
  }
  return std::abs(area);
}

/// How far apart corners may face each other to share a node: as in a mesh of 2,500 triangles (PMeshOptions).
double corners_meet(const Garment& garment) {
  return 0.0016 * std::sqrt(area_of_outlines(garment));
}

/// Pieces as cells. Every stretch has two ends, 2 s at its start and 2 s + 1 at its end; along a loop one stretch ends
/// at the node where the next one starts, and the cloth lies to the left of both.
class Cells {
 public:
  explicit Cells(const Garment& garment)
      : bundles_(make_bundles(garment, corners_meet(garment))),
        nodes_(bundles_.stretches.size()),
        sheets_(2 * bundles_.stretches.size()),
        together_(bundles_.stretches.size()),
        sides_(2 * garment.pieces.size()),
        next_(bundles_.stretches.size()) {
    for (const auto& loops : bundles_.loops) {
      for (const auto& loop : loops) walk(loop);
    }
    for (const auto& members : bundles_.members) {
      for (const int stretch : members) sew(members.front(), stretch);
    }
    for (const auto& members : bundles_.members) {
      if (members.size() == 2) go_on(members[0], members[1]);
    }
  }

  Topology topology(const Garment& garment) {
    Topology topology;
    const int stretches = static_cast<int>(bundles_.stretches.size());
    topology.euler = -static_cast<int>(bundles_.members.size());
    for (const Piece& piece : garment.pieces) topology.euler += 1 - static_cast<int>(piece.holes.size());
    for (int s = 0; s < stretches; ++s) {
      topology.euler += nodes_.find(s) == s;
      topology.components += together_.find(s) == s;
    }
    topology.boundary_loops = count_boundary_loops();
    const int pieces = static_cast<int>(garment.pieces.size());
    for (int p = 0; p < pieces; ++p) topology.orientable &= sides_.find(p) != sides_.find(p + pieces);
    topology.manifold = is_manifold();
    return topology;
  }

 private:
  /// A node is called by the stretch that starts there.
  int node(int stretch_end) const { return stretch_end % 2 == 0 ? stretch_end / 2 : next_[stretch_end / 2]; }

  void walk(const std::vector<int>& loop) {
    std::vector<int> round;
    for (const int edge : loop) {
      const OutlineEdge& e = bundles_.edges[edge];
      for (int i = 0; i + 1 < static_cast<int>(e.breaks.size()); ++i) round.push_back(e.first_stretch + i);
    }
    const int home = bundles_.loops[bundles_.edges[loop.front()].piece].front().front();
    for (std::size_t i = 0; i < round.size(); ++i) {
      const int after = round[(i + 1) % round.size()];
      next_[round[i]] = after;
      sheets_.unite(2 * round[i] + 1, 2 * after);
      together_.unite(round[i], bundles_.edges[home].first_stretch);
    }
  }

  bool alike(int a, int b) const { return bundles_.stretches[a].forward == bundles_.stretches[b].forward; }

  void sew(int a, int b) {
    const int turned = alike(a, b) ? 0 : 1;
    for (const int end : {0, 1}) {
      const int first = node(2 * a + end), second = node(2 * b + (end ^ turned));
      nodes_.unite(first, second);
      together_.unite(first, second);
    }
  }

  /// Across a seam of two the cloth goes on.
  void go_on(int a, int b) {
    const int turned = alike(a, b) ? 0 : 1;
    for (const int end : {0, 1}) sheets_.unite(2 * a + end, 2 * b + (end ^ turned));
    const int pieces = static_cast<int>(bundles_.loops.size());
    const int p = bundles_.edges[bundles_.stretches[a].edge].piece,
              q = bundles_.edges[bundles_.stretches[b].edge].piece;
    // Both have their cloth on the left: where they run the same way one of them is turned over.
    sides_.unite(p, turned == 0 ? q + pieces : q);
    sides_.unite(p + pieces, turned == 0 ? q : q + pieces);
  }

  int count_boundary_loops() {
    std::vector<int> free;
    for (const auto& members : bundles_.members) {
      if (members.size() == 1) free.push_back(members.front());
    }
    DisjointSets loops(bundles_.stretches.size());
    std::vector<int> met(2 * bundles_.stretches.size(), -1);  // the free stretch met at a sheet
    for (const int stretch : free) {
      for (const int end : {2 * stretch, 2 * stretch + 1}) {
        int& other = met[sheets_.find(end)];
        if (other < 0) {
          other = stretch;
        } else {
          loops.unite(stretch, other);
        }
      }
    }
    return static_cast<int>(std::count_if(free.begin(), free.end(), [&](int s) { return loops.find(s) == s; }));
  }

  bool is_manifold() {
    for (const auto& members : bundles_.members) {
      if (members.size() > 2) return false;
    }
    std::vector<int> sheet_at(bundles_.stretches.size(), -1);
    for (int end = 0; end < 2 * static_cast<int>(bundles_.stretches.size()); ++end) {
      int& known = sheet_at[nodes_.find(node(end))];
      const int sheet = sheets_.find(end);
      if (known >= 0 && known != sheet) return false;
      known = sheet;
    }
    return true;
  }

  Bundles bundles_;
  DisjointSets nodes_;     // by the stretch that starts there
  DisjointSets sheets_;    // ends of stretches that one sheet of cloth holds together
  DisjointSets together_;  // stretches of one component
  DisjointSets sides_;     // pieces as they are drawn, and turned over
  std::vector<int> next_;  // along the loop
};

}  // namespace

Topology sewn_topology(const Garment& garment) {
  const bool has_lines = std::any_of(garment.pieces.begin(), garment.pieces.end(),
                                     [](const Piece& piece) { return !piece.lines.empty(); });
  if (!has_lines) return Cells(garment).topology(garment);
  PMeshOptions options;
  options.target_edge = edge_for_triangles(garment, 500);
  return sew(garment, options).s.topology;
}

}  // namespace toile
