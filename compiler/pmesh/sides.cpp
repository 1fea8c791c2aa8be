#include "compiler/pmesh/sides.hpp"

namespace toile {

std::vector<Vec2> nodes_of(const PlaneDomain& domain) {
  std::vector<Vec2> nodes;
  for (const auto& loop : domain.loops) nodes.insert(nodes.end(), loop.begin(), loop.end());
  nodes.insert(nodes.end(), domain.line_nodes.begin(), domain.line_nodes.end());
  return nodes;
}

std::vector<DomainSide> sides_of(const PlaneDomain& domain) {
  std::vector<DomainSide> sides;
  int loop = 0, first = 0;
  for (const auto& nodes : domain.loops) {
    const int n = static_cast<int>(nodes.size());
    for (int i = 0; i < n; ++i) sides.push_back({loop, i, first + i, first + (i + 1) % n});
    first += n;
    ++loop;
  }
  for (const auto& nodes : domain.lines) {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      sides.push_back({loop, static_cast<int>(i), nodes[i], nodes[i + 1]});
    }
    ++loop;
  }
  return sides;
}

std::vector<OutlineSplit> crossing_sides(const PlaneDomain& domain, const DomainSide& side) {
  const std::vector<Vec2> nodes = nodes_of(domain);
  const Vec2 a = nodes[side.a], b = nodes[side.b];
  const auto side_of = [](Vec2 p, Vec2 q, Vec2 x) { return cross(q - p, x - p); };
  std::vector<OutlineSplit> splits{{side.loop, side.from, 0.5}};
  for (const DomainSide& other : sides_of(domain)) {
    const Vec2 c = nodes[other.a], d = nodes[other.b];
    const bool apart = side_of(a, b, c) * side_of(a, b, d) > 0 || side_of(c, d, a) * side_of(c, d, b) > 0;
    const bool joined = a == c || a == d || b == c || b == d;
    if (!apart && !joined) splits.push_back({other.loop, other.from, 0.5});
  }
  return splits;
}

}  // namespace toile
