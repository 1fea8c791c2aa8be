#include "compiler/pmesh/division.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/pmesh/spacing.hpp"

namespace toile {
namespace {

constexpr double kCornersMeet = 0.05;   // of the target edge
constexpr double kShortestSide = 2e-6;  // [m] a side shorter than this is divided no further

/// A loop of one or two edges needs more nodes than its edges have ends, and so does a line that closes.
int least_sides(const Bundles& bundles, const Stretch& stretch, int asked) {
  const OutlineEdge& edge = bundles.edges[stretch.edge];
  std::size_t stretches = 0;
  for (const int e : bundles.loops[edge.piece][edge.loop]) stretches += bundles.edges[e].breaks.size() - 1;
  return std::max(asked, stretches == 1 ? 4 : stretches == 2 ? 2 : 1);
}

}  // namespace

Division::Division(const Garment& garment, const PMeshOptions& options)
    : bundles_(make_bundles(garment, kCornersMeet * options.target_edge)) {
  for (const auto& members : bundles_.members) {
    std::vector<SpacingMember> spaced;
    SpacingBounds bounds{options.target_edge, options.chord_error, 1};
    for (const int i : members) {
      const Stretch& stretch = bundles_.stretches[i];
      spaced.push_back({bundles_.edges[stretch.edge].curve, stretch.from, stretch.to, stretch.forward});
      bounds.least = std::max(bounds.least, least_sides(bundles_, stretch, options.least_divisions));
    }
    fractions_.push_back(divide_alike(spaced, bounds));
  }
  arcs_.resize(bundles_.edges.size());
  points_.resize(bundles_.edges.size());
  for (int e = 0; e < static_cast<int>(bundles_.edges.size()); ++e) place(e);
}

void Division::place(int edge) {
  const OutlineEdge& e = bundles_.edges[edge];
  std::vector<double> arcs{0};
  for (std::size_t i = 0; i + 1 < e.breaks.size(); ++i) {
    const Stretch& stretch = bundles_.stretches[e.first_stretch + static_cast<int>(i)];
    const auto& t = fractions_[stretch.bundle];
    for (std::size_t k = 1; k + 1 < t.size(); ++k) {
      arcs.push_back(stretch.forward ? stretch.from + t[k] * stretch.length()
                                     : stretch.to - t[t.size() - 1 - k] * stretch.length());
    }
    arcs.push_back(stretch.to);
  }
  points_[edge].clear();
  for (const double s : arcs) points_[edge].push_back(e.curve->at(s));
  arcs_[edge] = std::move(arcs);
}

int Division::first_node(int stretch) const {
  int node = 0;
  for (int i = bundles_.edges[bundles_.stretches[stretch].edge].first_stretch; i < stretch; ++i) {
    node += static_cast<int>(fractions_[bundles_.stretches[i].bundle].size()) - 1;
  }
  return node;
}

double Division::shortest_member(int bundle) const {
  double shortest = 1e300;
  for (const int i : bundles_.members[bundle]) shortest = std::min(shortest, bundles_.stretches[i].length());
  return shortest;
}

std::vector<int> Division::split(const std::vector<SideSplit>& wishes) {
  std::map<std::pair<int, int>, std::map<int, std::vector<double>>> wanted;  // [bundle, side][edge that wishes]
  for (const SideSplit& wish : wishes) {
    const OutlineEdge& edge = bundles_.edges[wish.edge];
    int i = edge.first_stretch, side = wish.side;
    const auto sides = [&](int stretch) {
      return static_cast<int>(fractions_[bundles_.stretches[stretch].bundle].size()) - 1;
    };
    while (side >= sides(i)) side -= sides(i++);
    const Stretch& stretch = bundles_.stretches[i];
    const int k = stretch.forward ? side : sides(i) - 1 - side;
    wanted[{stretch.bundle, k}][wish.edge].push_back(stretch.forward ? wish.fraction : 1 - wish.fraction);
  }
  std::vector<int> touched;
  std::map<int, std::vector<double>> added;
  for (const auto& [key, by_edge] : wanted) {
    const auto [bundle, side] = key;
    const auto heard = std::max_element(by_edge.begin(), by_edge.end(),
                                        [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    const double t0 = fractions_[bundle][side], t1 = fractions_[bundle][side + 1];
    if ((t1 - t0) * shortest_member(bundle) < kShortestSide) continue;
    for (const double f : heard->second) added[bundle].push_back(t0 + f * (t1 - t0));
  }
  for (auto& [bundle, more] : added) {
    auto& t = fractions_[bundle];
    t.insert(t.end(), more.begin(), more.end());
    std::sort(t.begin(), t.end());
    t.erase(std::unique(t.begin(), t.end()), t.end());
    for (const int i : bundles_.members[bundle]) touched.push_back(bundles_.stretches[i].edge);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const int edge : touched) place(edge);
  return touched;
}

std::vector<std::vector<Division::Run>> Division::sewn_nodes() const {
  std::vector<std::vector<Run>> seams;
  for (const auto& pairs : bundles_.seams) {
    std::vector<Run>& runs = seams.emplace_back();
    for (const SewnStretches& pair : pairs) {
      const int n = static_cast<int>(fractions_[bundles_.stretches[pair.first].bundle].size());
      const int a = first_node(pair.first), b = first_node(pair.second);
      Run& run = runs.emplace_back();
      for (int k = 0; k < n; ++k) {
        run.push_back({EdgeNode{bundles_.stretches[pair.first].edge, a + (pair.first_forward ? k : n - 1 - k)},
                       EdgeNode{bundles_.stretches[pair.second].edge, b + (pair.second_forward ? k : n - 1 - k)}});
      }
    }
  }
  return seams;
}

}  // namespace toile
