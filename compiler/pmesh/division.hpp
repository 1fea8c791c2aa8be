// The nodes on the outlines of all pieces, the same fractions along all that is sewn together.
#pragma once

#include <array>
#include <vector>

#include "compiler/pmesh/bundles.hpp"
#include "compiler/pmesh/pmesh.hpp"

namespace toile {

/// A node of an outline edge: the `node`-th from its start.
struct EdgeNode {
  int edge = 0;
  int node = 0;
};

/// A wish to divide the side from a node of an edge to the next.
struct SideSplit {
  int edge = 0;
  int side = 0;
  double fraction = 0.5;  // of the side
};

class Division {
 public:
  Division(const Garment& garment, const PMeshOptions& options);

  const Bundles& bundles() const { return bundles_; }
  /// Arc lengths of an edge's nodes, 0 to its length.
  const std::vector<double>& arcs(int edge) const { return arcs_[edge]; }
  /// Their places on the curve.
  const std::vector<Vec2>& points(int edge) const { return points_[edge]; }

  /// Divides sides, and with each those sewn to it. Where several pieces want one side divided, the one with most
  /// wishes is heard. Returns the edges that have changed, ascending.
  std::vector<int> split(const std::vector<SideSplit>& wishes);

  /// The nodes that each seam joins: for each of its stretches a run of pairs.
  using Run = std::vector<std::array<EdgeNode, 2>>;
  std::vector<std::vector<Run>> sewn_nodes() const;

 private:
  void place(int edge);
  int first_node(int stretch) const;
  double shortest_member(int bundle) const;

  Bundles bundles_;
  std::vector<std::vector<double>> fractions_;  // [bundle], 0 to 1
  std::vector<std::vector<double>> arcs_;       // [edge]
  std::vector<std::vector<Vec2>> points_;       // [edge]
};

}  // namespace toile
