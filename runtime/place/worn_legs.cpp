#include "runtime/place/worn_legs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "runtime/place/chain_parts.hpp"
#include "runtime/place/fullness.hpp"
#include "runtime/place/leg_rings.hpp"
#include "runtime/place/winding.hpp"

namespace toile {
namespace {

constexpr double most_seen_along_axis = 0.8;  // of its length, for a line that runs along the axis

Vec3 middle_of(const std::vector<Vec3>& points) {
  Vec3 sum;
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

// Puts the chain's vertices from `first` up to `last` on the body's line, evenly between those two, which are known. In
// a closed chain the numbers go on beyond its end.
void lay_between(HangingChain& chain, std::size_t first, std::size_t last) {
  const std::size_t n = chain.vertices.size();
  const auto arc = [&](std::size_t i) { return chain.worn->arc[i % n] + (i >= n ? chain.worn->length : 0); };
  const double start = chain.curve.fraction_near(chain.positions[first % n]);
  const double end = chain.curve.fraction_near(chain.positions[last % n]);
  const double length = arc(last) - arc(first), wanted = length / chain.curve.length();
  double way = end - start - std::floor(end - start);  // one way round, or the rest of the turn the other way
  if (std::abs(way - wanted) > std::abs(1 - way - wanted)) way -= 1;
  for (std::size_t i = first + 1; i < last; ++i) {
    chain.positions[i % n] = chain.curve.at(start + way * (arc(i) - arc(first)) / length);
  }
}

void lay_between_known(const std::map<int, Vec3>& known, HangingChain& chain) {
  std::vector<std::size_t> fixed;
  for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
    const auto found = known.find(chain.vertices[i]);
    if (found == known.end()) continue;
    chain.positions[i] = found->second;
    fixed.push_back(i);
  }
  if (fixed.size() < 2) return;
  if (chain.worn->closed) fixed.push_back(fixed.front() + chain.vertices.size());
  for (std::size_t k = 0; k + 1 < fixed.size(); ++k) lay_between(chain, fixed[k], fixed[k + 1]);
}

// The line along whose leg a part goes: of those that bound it, the one nearest to all that bounds it.
std::optional<int> leg_of(const RestMesh& rest, const std::vector<int>& part, const std::vector<HungLine>& hung,
                          std::size_t vertex_count) {
  std::vector<bool> inside(vertex_count, false);
  for (const int v : part) inside[v] = true;
  std::vector<Vec3> bounds;
  std::vector<int> candidates;
  for (std::size_t l = 0; l < hung.size(); ++l) {
    const std::size_t before = bounds.size();
    const HangingChain& chain = hung[l].chain;
    for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
      if (touches(rest, chain.vertices[i], inside)) bounds.push_back(chain.positions[i]);
    }
    if (bounds.size() > before && runs_along_axis(*hung[l].line)) candidates.push_back(static_cast<int>(l));
  }
  if (candidates.empty()) return std::nullopt;
  const Vec3 middle = middle_of(bounds);
  return *std::min_element(candidates.begin(), candidates.end(), [&](int a, int b) {
    return distance(middle_of(hung[a].line->points), middle) < distance(middle_of(hung[b].line->points), middle);
  });
}

Vec2 gradient(const ClothTriangle& t, const std::vector<double>& values) {
  const Vec2 x = t.uv[1] - t.uv[0], y = t.uv[2] - t.uv[0];
  const double dx = values[t.vertices[1]] - values[t.vertices[0]], dy = values[t.vertices[2]] - values[t.vertices[0]];
  return (dx * perpendicular(-y) + dy * perpendicular(x)) / cross(x, y);
}

// The sources of a function that grows by one a metre in the direction in which `values` grow.
std::vector<double> sources_of_even_growth(const Cloth& cloth, const std::vector<bool>& counted,
                                           const std::vector<double>& values) {
  std::vector<double> sources(counted.size(), 0.0);
  for (const ClothTriangle& t : cloth.triangles) {
    const double twice_area = cross(t.uv[1] - t.uv[0], t.uv[2] - t.uv[0]);
    const Vec2 growth = gradient(t, values);
    const bool counts = std::all_of(t.vertices.begin(), t.vertices.end(), [&](int v) { return counted[v]; });
    if (!counts || !(norm(growth) > 1e-9)) continue;
    for (int c = 0; c < 3; ++c) {
      const Vec2 opposite = t.uv[(c + 2) % 3] - t.uv[(c + 1) % 3];
      sources[t.vertices[c]] += std::copysign(0.5, twice_area) * dot(growth / norm(growth), perpendicular(opposite));
    }
  }
  return sources;
}

// What leaves the cloth at its free edges when it flows away from the chains.
std::vector<double> outflow(const Cloth& cloth, const std::vector<bool>& own, const std::vector<double>& depth) {
  std::vector<double> flow(own.size(), 0.0);
  for (const SMesh::Edge& edge : cloth.edges) {
    const auto [a, b] = edge.vertices;
    if (edge.wings.size() != 1 || !own[a] || !own[b]) continue;
    const ClothTriangle& t = cloth.triangles[edge.wings[0].triangle];
    const int corner = edge.wings[0].corner;
    const Vec2 along = t.uv[(corner + 2) % 3] - t.uv[(corner + 1) % 3], away = gradient(t, depth);
    const Vec2 outwards = std::copysign(1.0, cross(t.uv[1] - t.uv[0], t.uv[2] - t.uv[0])) * -perpendicular(along);
    for (const int v : {a, b}) flow[v] += 0.5 * dot(outwards, away) / std::max(norm(away), 1e-9);
  }
  return flow;
}

// Fills in the levels of a leg's own vertices; those of the chains about them are known. The way down is that of a flow
// from the chains to the hems; along it levels change by the lengths on the cloth.
void find_levels(const RestMesh& rest, const std::vector<bool>& own, const std::vector<bool>& about,
                 const std::vector<double>& depth, std::vector<double>& level) {
  const Cloth& cloth = rest.cloth();
  const auto solved = [&](const std::vector<double>& sources) {
    std::vector<double> values =
        harmonic_correction(cloth, own, sources, [&](int v, int w) { return level[w] - level[v]; });
    for (std::size_t v = 0; v < own.size(); ++v) values[v] += level[v];
    return values;
  };
  const std::vector<double> flow = solved(outflow(cloth, own, depth));
  level = solved(sources_of_even_growth(cloth, about, flow));
}

}  // namespace

bool runs_along_axis(const BodyLine& line) {
  double seen = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vec3 way = line.points[(i + 1) % line.points.size()] - line.points[i];
    seen += norm(way - dot(way, line.axis) * line.axis);
  }
  return seen < most_seen_along_axis * line.girth;
}

void run_between_other_lines(std::vector<HungLine>& hung) {
  std::map<int, Vec3> known;
  for (const HungLine& h : hung) {
    if (runs_along_axis(*h.line)) continue;
    for (std::size_t i = 0; i < h.chain.vertices.size(); ++i) known[h.chain.vertices[i]] = h.chain.positions[i];
  }
  for (HungLine& h : hung) {
    if (!runs_along_axis(*h.line)) continue;
    lay_between_known(known, h.chain);
    for (std::size_t i = 0; i < h.chain.vertices.size(); ++i) known.emplace(h.chain.vertices[i], h.chain.positions[i]);
  }
}

void assign_legs(const RestMesh& rest, const std::vector<int>& members, const std::vector<HungLine>& hung,
                 std::vector<int>& line_of) {
  if (std::none_of(hung.begin(), hung.end(), [](const HungLine& h) { return runs_along_axis(*h.line); })) return;
  for (const auto& [part, bounds] : parts_between_chains(rest, members, hung)) {
    const std::optional<int> leg = leg_of(rest, part, hung, line_of.size());
    if (!leg) continue;
    for (const int v : part) line_of[v] = *leg;
  }
}

void place_leg(const RestMesh& rest, const std::vector<HungLine>& hung, int leg, const std::vector<int>& line_of,
               const Body& body, double clearance, std::vector<Vec3>& positions) {
  const std::size_t n = positions.size();
  const BodyLine& line = *hung[leg].line;
  const LegFrame frame(line.axis);
  const std::vector<bool> on_chain = on_any_chain(hung, n);
  std::vector<bool> own(n, false);
  for (std::size_t v = 0; v < n; ++v) own[v] = line_of[v] == leg && !on_chain[v];

  std::vector<int> bounds;
  std::vector<double> level(n, 0.0);
  std::vector<bool> about = own;
  double top = 1e300, fork = -1e300;
  for (std::size_t v = 0; v < n; ++v) {
    if (!on_chain[v] || !touches(rest, static_cast<int>(v), own)) continue;
    bounds.push_back(static_cast<int>(v));
    about[v] = true;
    level[v] = frame.level(positions[v]);
    top = std::min(top, level[v]);
    fork = std::max(fork, level[v]);
  }
  if (bounds.empty()) return;
  find_levels(rest, own, about, rest.distance_from(bounds), level);
  double bottom = fork;
  for (std::size_t v = 0; v < n; ++v) {
    if (own[v]) bottom = std::max(bottom, level[v]);
  }

  const Vec3 start = middle_of(line.points);
  std::vector<Divide> divides;
  for (std::size_t l = 0; l < hung.size(); ++l) {
    if (static_cast<int>(l) == leg || !runs_along_axis(*hung[l].line)) continue;
    const Vec3 other = middle_of(hung[l].line->points);
    divides.push_back({0.5 * (start + other), normalized(other - start)});
  }
  const LegRings rings(body, frame, divides, start, top, bottom, clearance);
  HangingChain chain{bounds, {}, hung[leg].chain.curve, {}, nullptr};
  for (const int v : bounds) chain.fractions.push_back(rings.fraction_of(positions[v]));
  const std::vector<double> fraction = winding(rest, chain, level, own);

  for (double& each : level) each -= top;
  const Fullness fullness = measure_fullness(rest, fraction, level, own, rings.girth(fork));
  const auto slack = [&](double below) {
    const double at = std::max(below, fork - top);
    const double wider = std::max(0.0, fullness.turn_at(at) - rings.girth(top + at)) / (2 * std::numbers::pi);
    return wider * std::clamp(below / std::max(fork - top, 1e-6), 0.0, 1.0);
  };
  for (std::size_t v = 0; v < n; ++v) {
    if (own[v]) positions[v] = rings.at(top + level[v], fraction[v], slack(level[v]));
  }
}

}  // namespace toile
