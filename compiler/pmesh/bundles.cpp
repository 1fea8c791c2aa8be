#include "compiler/pmesh/bundles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace toile {
namespace {

constexpr int kSeamRounds = 24;           // a corner wanders through this many seams at most
constexpr std::size_t kMostBreaks = 400;  // of one edge
constexpr double kKink = 0.03;            // [rad] a turn of the tangent that needs a node
constexpr double kSame = 1e-9;            // [m]

std::vector<double> ends_and_kinks(const Curve& curve) {
  std::vector<double> breaks{0};
  double s = 0;
  const auto& segments = curve.segments();
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    const Curve here({segments[i]}), next({segments[i + 1]});
    s += here.length();
    const Vec2 a = here.tangent(here.length()), b = next.tangent(0);
    if (std::abs(std::atan2(cross(a, b), dot(a, b))) > kKink && s > breaks.back() + kSame) breaks.push_back(s);
  }
  const double length = curve.length();
  if (breaks.size() > 1 && breaks.back() > length - kSame) breaks.pop_back();
  breaks.push_back(length);
  return breaks;
}

/// A chain laid out straight: the breaks of its edges as positions along it.
class ChainLine {
 public:
  ChainLine(const Chain& chain, Bundles& bundles) : bundles_(bundles) {
    for (const ChainLink& link : chain) {
      const int edge = bundles.edge(link.edge);
      links_.push_back({edge, link.forward, length_});
      const OutlineEdge& e = bundles.edges[edge];
      std::vector<double> along;
      for (const double s : e.breaks) along.push_back(length_ + (link.forward ? s : e.length - s));
      if (!link.forward) std::reverse(along.begin(), along.end());
      positions_.insert(positions_.end(), along.begin() + (positions_.empty() ? 0 : 1), along.end());
      length_ += e.length;
    }
  }

  const std::vector<double>& positions() const { return positions_; }
  double length() const { return length_; }
  double gap(std::size_t i) const {
    return std::min(positions_[i] - positions_[i - 1], positions_[i + 1] - positions_[i]);
  }

  /// Puts a break there; false where there is one or the edge has had its share.
  bool add_break(double position) {
    auto link =
        std::upper_bound(links_.begin(), links_.end(), position, [](double p, const Link& l) { return p < l.offset; });
    if (link != links_.begin()) --link;
    OutlineEdge& e = bundles_.edges[link->edge];
    const double along = position - link->offset;
    const double s = link->forward ? along : e.length - along;
    if (s < kSame || s > e.length - kSame || e.breaks.size() >= kMostBreaks) return false;
    const auto at = std::lower_bound(e.breaks.begin(), e.breaks.end(), s);
    if (*at - s < kSame || s - *(at - 1) < kSame) return false;
    e.breaks.insert(at, s);
    return true;
  }

  struct DirectedStretch {
    int stretch = 0;
    bool forward = true;
  };
  /// The stretches between the positions, once they are numbered.
  std::vector<DirectedStretch> stretches() const {
    std::vector<DirectedStretch> all;
    for (const Link& link : links_) {
      const OutlineEdge& e = bundles_.edges[link.edge];
      const int n = static_cast<int>(e.breaks.size()) - 1;
      for (int i = 0; i < n; ++i) all.push_back({e.first_stretch + (link.forward ? i : n - 1 - i), link.forward});
    }
    return all;
  }

 private:
  struct Link {
    int edge = 0;
    bool forward = true;
    double offset = 0;
  };
  Bundles& bundles_;
  std::vector<Link> links_;
  std::vector<double> positions_;
  double length_ = 0;
};

using Match = std::array<std::size_t, 2>;

/// Pairs of positions between two pairs that are known; the last of these is added, too.
void match_between(const ChainLine& a, const ChainLine& b, double tolerance, Match last, std::vector<Match>& pairs) {
  const auto &pa = a.positions(), &pb = b.positions();
  const Match first = pairs.back();
  const double la = pa[last[0]] - pa[first[0]], lb = pb[last[1]] - pb[first[1]], longer = std::max(la, lb);
  std::size_t i = first[0] + 1, j = first[1] + 1;
  while (i < last[0] && j < last[1]) {
    const double difference = ((pa[i] - pa[first[0]]) / la - (pb[j] - pb[first[1]]) / lb) * longer;
    const double within = std::max(kSame, std::min({tolerance, 0.25 * a.gap(i), 0.25 * b.gap(j)}));
    if (std::abs(difference) <= within) {
      pairs.push_back({i++, j++});
    } else {
      ++(difference < 0 ? i : j);
    }
  }
  pairs.push_back(last);
}

std::size_t nearest_position(const ChainLine& line, double position) {
  const auto& p = line.positions();
  const auto after = std::lower_bound(p.begin(), p.end(), position);
  if (after == p.begin()) return 0;
  if (after == p.end() || position - *(after - 1) < *after - position) return after - p.begin() - 1;
  return after - p.begin();
}

/// Pairs of positions, one on each line, that are one node; first and last among them, and those that are tied.
std::vector<Match> matches(const ChainLine& a, const ChainLine& b, const Seam& seam, double tolerance) {
  const Match last{a.positions().size() - 1, b.positions().size() - 1};
  std::vector<Match> pairs{{0, 0}};
  for (const auto& tie : seam.ties) {
    const Match tied{nearest_position(a, tie[0]), nearest_position(b, tie[1])};
    const bool between =
        tied[0] > pairs.back()[0] && tied[1] > pairs.back()[1] && tied[0] < last[0] && tied[1] < last[1];
    if (between) match_between(a, b, tolerance, tied, pairs);
  }
  match_between(a, b, tolerance, last, pairs);
  return pairs;
}

/// Gives `to` the breaks that only `from` has; `side` is from's place in the pairs.
bool carry(const ChainLine& from, ChainLine& to, const std::vector<std::array<std::size_t, 2>>& pairs, int side) {
  bool any = false;
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k) {
    const std::size_t begin = pairs[k][side], end = pairs[k + 1][side];
    const double f0 = from.positions()[begin], f1 = from.positions()[end];
    const double t0 = to.positions()[pairs[k][1 - side]], t1 = to.positions()[pairs[k + 1][1 - side]];
    for (std::size_t i = begin + 1; i < end; ++i) {
      any |= to.add_break(t0 + (from.positions()[i] - f0) / (f1 - f0) * (t1 - t0));
    }
  }
  return any;
}

bool sewable(const Seam& seam, const Bundles& bundles) {
  const auto length = [&](const Chain& chain) {
    return std::accumulate(chain.begin(), chain.end(), 0.0, [&](double sum, const ChainLink& link) {
      return sum + bundles.edges[bundles.edge(link.edge)].length;
    });
  };
  return !seam.open && length(seam.first) > kSame && length(seam.second) > kSame;
}

/// Tied places get their nodes before corners are carried across.
void break_at_ties(const Garment& garment, Bundles& bundles) {
  for (const Seam& seam : garment.seams) {
    for (const auto& tie : seam.ties) {
      if (!sewable(seam, bundles)) continue;
      ChainLine(seam.first, bundles).add_break(tie[0]);
      ChainLine(seam.second, bundles).add_break(tie[1]);
    }
  }
}

void carry_breaks(const Garment& garment, double tolerance, Bundles& bundles) {
  break_at_ties(garment, bundles);
  for (int round = 0; round < kSeamRounds; ++round) {
    bool any = false;
    for (const Seam& seam : garment.seams) {
      if (!sewable(seam, bundles)) continue;
      ChainLine first(seam.first, bundles), second(seam.second, bundles);
      const auto pairs = matches(first, second, seam, tolerance);
      any |= carry(first, second, pairs, 0);
      any |= carry(second, first, pairs, 1);
    }
    if (!any) return;
  }
}

void number_stretches(Bundles& bundles) {
  bundles.stretches.clear();
  for (int e = 0; e < static_cast<int>(bundles.edges.size()); ++e) {
    OutlineEdge& edge = bundles.edges[e];
    edge.first_stretch = static_cast<int>(bundles.stretches.size());
    for (std::size_t i = 0; i + 1 < edge.breaks.size(); ++i) {
      bundles.stretches.push_back({e, edge.breaks[i], edge.breaks[i + 1], 0, true});
    }
  }
}

void pair_stretches(const Garment& garment, double tolerance, Bundles& bundles) {
  bundles.seams.assign(garment.seams.size(), {});
  for (std::size_t s = 0; s < garment.seams.size(); ++s) {
    const Seam& seam = garment.seams[s];
    if (!sewable(seam, bundles)) continue;
    const ChainLine first(seam.first, bundles), second(seam.second, bundles);
    const auto a = first.stretches(), b = second.stretches();
    const auto pairs = matches(first, second, seam, tolerance);
    for (std::size_t k = 0; k + 1 < pairs.size(); ++k) {
      // Where the rounds ran out a corner may be left without its partner: that stretch stays open.
      if (pairs[k + 1][0] != pairs[k][0] + 1 || pairs[k + 1][1] != pairs[k][1] + 1) continue;
      const auto &x = a[pairs[k][0]], &y = b[pairs[k][1]];
      bundles.seams[s].push_back({x.stretch, y.stretch, x.forward, y.forward});
    }
  }
}

/// Union-find with a turn: each stretch knows its bundle's smallest stretch and whether it runs the same way.
class Turns {
 public:
  explicit Turns(std::size_t count) : parent_(count), same_(count, true) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  struct Root {
    int stretch = 0;
    bool same = true;
  };
  Root root(int stretch) const {
    Root r{stretch, true};
    while (parent_[r.stretch] != r.stretch) {
      r.same = r.same == same_[r.stretch];
      r.stretch = parent_[r.stretch];
    }
    return r;
  }
  /// False when the two are one already, the other way round.
  bool unite(int a, int b, bool same) {
    const Root ra = root(a), rb = root(b);
    const bool turn = (ra.same == rb.same) == same;
    if (ra.stretch == rb.stretch) return turn;
    const auto [low, high] = std::minmax(ra.stretch, rb.stretch);
    parent_[high] = low;
    same_[high] = turn;
    return true;
  }

 private:
  std::vector<int> parent_;
  std::vector<bool> same_;
};

/// Returns the stretches sewn to themselves turned round.
std::vector<int> bundle_stretches(Bundles& bundles) {
  Turns turns(bundles.stretches.size());
  std::vector<int> folded;
  for (auto& seam : bundles.seams) {
    std::erase_if(seam, [&](const SewnStretches& pair) {
      const bool ok = turns.unite(pair.first, pair.second, pair.first_forward == pair.second_forward);
      if (!ok) folded.push_back(turns.root(pair.first).stretch);
      return !ok;
    });
  }
  bundles.members.clear();
  std::vector<int> bundle_of_root(bundles.stretches.size(), -1);
  std::vector<int> turned_in;
  for (int i = 0; i < static_cast<int>(bundles.stretches.size()); ++i) {
    const auto [root, same] = turns.root(i);
    if (bundle_of_root[root] < 0) {
      bundle_of_root[root] = static_cast<int>(bundles.members.size());
      bundles.members.emplace_back();
    }
    bundles.stretches[i].bundle = bundle_of_root[root];
    bundles.stretches[i].forward = same;
    bundles.members[bundle_of_root[root]].push_back(i);
    if (std::find(folded.begin(), folded.end(), root) != folded.end()) turned_in.push_back(i);
  }
  return turned_in;
}

void add_edges(const std::vector<PieceEdge>& loop, PieceId piece, Bundles& bundles) {
  std::vector<int>& ids = bundles.loops[piece].emplace_back();
  for (const PieceEdge& edge : loop) {
    ids.push_back(static_cast<int>(bundles.edges.size()));
    const int index = static_cast<int>(bundles.loops[piece].size()) - 1;
    bundles.edges.push_back({piece, index, &edge.curve, edge.curve.length(), ends_and_kinks(edge.curve), 0});
  }
}

}  // namespace

Bundles make_bundles(const Garment& garment, double tolerance) {
  Bundles bundles;
  bundles.loops.resize(garment.pieces.size());
  for (int p = 0; p < static_cast<int>(garment.pieces.size()); ++p) {
    add_edges(garment.pieces[p].edges, p, bundles);
    for (const auto& hole : garment.pieces[p].holes) add_edges(hole, p, bundles);
    bundles.closed.push_back(static_cast<int>(bundles.loops[p].size()));
    for (const auto& line : garment.pieces[p].lines) add_edges(line, p, bundles);
  }
  for (int attempt = 0; attempt < 4; ++attempt) {
    carry_breaks(garment, tolerance, bundles);
    number_stretches(bundles);
    pair_stretches(garment, tolerance, bundles);
    const std::vector<int> folded = bundle_stretches(bundles);
    if (folded.empty()) break;
    for (const int i : folded) {
      const Stretch& stretch = bundles.stretches[i];
      auto& breaks = bundles.edges[stretch.edge].breaks;
      const double middle = (stretch.from + stretch.to) / 2;
      breaks.insert(std::upper_bound(breaks.begin(), breaks.end(), middle), middle);
    }
  }
  return bundles;
}

}  // namespace toile
