// Which triangles are refined, how urgently, and where a side of the outline is split.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "compiler/pmesh/triangulate.hpp"

namespace toile {

class RefinementRules {
 public:
  RefinementRules(const PlaneDomain& domain, const TriangulationSize& size);

  /// 0 for a triangle that may stay; below 1 for a small angle, the smaller the more urgent; above 1 for one too large.
  double urgency(const std::array<Vec2, 3>& triangle) const;
  /// Where to split the side from p to q, as a fraction: in the middle, or on a shell of radius 2^k m about an acute
  /// corner at one end. Nothing for a side that is short enough.
  std::optional<double> place_of_split(Vec2 p, Vec2 q) const;
  /// Shewchuk's diametral lens: p sees the side between a and b under more than 120 degrees.
  static bool encroaches(Vec2 p, Vec2 a, Vec2 b);
  /// Bound for the number of nodes that refinement may add.
  long most_nodes(double area, std::size_t given) const;

 private:
  struct Corner {
    Vec2 at;
    double angle = 0;
  };

  void add_corners_of_lines(const PlaneDomain& domain);
  bool acute_at(Vec2 p) const;
  bool excused(Vec2 apex, Vec2 a, Vec2 b) const;
  double edge_at(Vec2 p) const;

  const TriangulationSize& size_;
  std::vector<Corner> acute_;
};

}  // namespace toile
