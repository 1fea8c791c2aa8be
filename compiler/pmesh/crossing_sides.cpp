#include "compiler/pmesh/crossing_sides.hpp"

namespace toile {

std::vector<OutlineSplit> crossing_sides(const Loops& loops, int loop, int side) {
  const auto end = [&](int l, int i) { return loops[l][i % loops[l].size()]; };
  const Vec2 a = end(loop, side), b = end(loop, side + 1);
  const auto side_of = [](Vec2 p, Vec2 q, Vec2 x) { return cross(q - p, x - p); };
  std::vector<OutlineSplit> splits{{loop, side, 0.5}};
  for (int l = 0; l < static_cast<int>(loops.size()); ++l) {
    for (int i = 0; i < static_cast<int>(loops[l].size()); ++i) {
      const Vec2 c = end(l, i), d = end(l, i + 1);
      const bool apart = side_of(a, b, c) * side_of(a, b, d) > 0 || side_of(c, d, a) * side_of(c, d, b) > 0;
      const bool joined = a == c || a == d || b == c || b == d;
      if (!apart && !joined) splits.push_back({l, i, 0.5});
    }
  }
  return splits;
}

}  // namespace toile
