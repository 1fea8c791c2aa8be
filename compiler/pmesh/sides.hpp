// The sides of a plane domain: those of its loops and of the lines inside.
#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "compiler/pmesh/triangulate.hpp"

namespace toile {

/// From the node `from` of a loop, or of a line, to the next; `a` and `b` are numbers in nodes_of().
struct DomainSide {
  int loop = 0;  // the lines come after the loops
  int from = 0;
  int a = 0, b = 0;
};

/// The loops' nodes, one loop after another, and then the lines' own.
std::vector<Vec2> nodes_of(const PlaneDomain& domain);
std::vector<DomainSide> sides_of(const PlaneDomain& domain);

/// Chords may cross where their curves do not: the given side and those that cross it, each to be split in its middle.
std::vector<OutlineSplit> crossing_sides(const PlaneDomain& domain, const DomainSide& side);

/// What refinement has made of the sides, by the two nodes that they lie between.
class DividedSides {
 public:
  /// From the node `first` on, between two fractions of a side.
  struct Part {
    int loop = 0;
    int from = 0;
    int first = 0;
    double begin = 0, end = 1;
  };

  void add(int a, int b, const Part& part) { parts_.emplace(std::minmax(a, b), part); }
  /// Null for an edge that lies on no side.
  const Part* between(int a, int b) const {
    const auto found = parts_.find(std::minmax(a, b));
    return found == parts_.end() ? nullptr : &found->second;
  }
  /// Puts the part from a to b in two at the node v; returns where on its side that is.
  double divide(int a, int b, int v, double share) {
    const auto found = parts_.find(std::minmax(a, b));
    const Part whole = found->second;
    parts_.erase(found);
    const double at = whole.begin + share * (whole.end - whole.begin);
    add(a, v, {whole.loop, whole.from, a, whole.begin, at});
    add(v, b, {whole.loop, whole.from, v, at, whole.end});
    return at;
  }

 private:
  std::map<std::pair<int, int>, Part> parts_;
};

}  // namespace toile
