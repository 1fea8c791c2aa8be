#include "runtime/place/worn_component.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/place/chain_parts.hpp"
#include "runtime/place/envelope.hpp"
#include "runtime/place/relax.hpp"
#include "runtime/place/tube_winding.hpp"
#include "runtime/place/turning.hpp"
#include "runtime/place/winding.hpp"
#include "runtime/place/worn_legs.hpp"

namespace toile {
namespace {

constexpr int relaxing_passes = 48;

double mean_over(const std::vector<int>& vertices, const std::vector<double>& values) {
  double sum = 0;
  for (const int v : vertices) sum += values[v];
  return sum / static_cast<double>(vertices.size());
}

Vec3 middle(const std::vector<Vec3>& points) {
  Vec3 sum;
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

// The lines that cloth may hang from that these bound. A chain with a part that no other bounds holds that one: an
// armhole its sleeve, and the trunk hangs from the neck.
std::vector<int> lines_for(const ChainPart& part, const std::vector<bool>& has_own) {
  std::vector<int> lines;
  for (const int l : part.bounds) {
    if (part.bounds.size() == 1 || !has_own[l]) lines.push_back(l);
  }
  return lines.empty() ? part.bounds : lines;
}

// The line that each member hangs from.
std::vector<int> assign(const RestMesh& rest, const std::vector<int>& members, const std::vector<HungLine>& hung,
                        const std::vector<std::vector<double>>& depth) {
  const std::vector<ChainPart> parts = parts_between_chains(rest, members, hung);
  std::vector<bool> has_own(hung.size(), false);
  for (const ChainPart& part : parts) {
    if (part.bounds.size() == 1) has_own[part.bounds.front()] = true;
  }
  std::vector<int> line_of(static_cast<std::size_t>(rest.vertex_count()), -1);
  for (const ChainPart& part : parts) {
    const std::vector<int> lines = lines_for(part, has_own);
    for (const int v : part.vertices) {
      line_of[v] =
          *std::min_element(lines.begin(), lines.end(), [&](int a, int b) { return depth[a][v] < depth[b][v]; });
    }
    // Between two lines one of which hangs below the other, cloth belongs to the upper.
    for (const int upper : lines) {
      for (const int lower : lines) {
        const Vec3 way = middle(hung[lower].chain.positions) - middle(hung[upper].chain.positions);
        const double distance_along = dot(hung[upper].line->axis, way);
        if (upper == lower || distance_along < 0.5 * norm(way)) continue;
        const double limit = mean_over(hung[lower].chain.vertices, depth[upper]);
        for (const int v : part.vertices) {
          if (line_of[v] == lower && depth[upper][v] < limit) line_of[v] = upper;
        }
      }
    }
  }
  for (std::size_t l = 0; l < hung.size(); ++l) {
    for (const int v : hung[l].chain.vertices) line_of[v] = static_cast<int>(l);
  }
  return line_of;
}

// Layers of a pleat lie over each other, away from the axis of what they are worn on.
void lift_layers(const PleatFolds& folds, const std::vector<int>& members, const BodyLine& line,
                 std::vector<Vec3>& positions) {
  constexpr double layer = 0.0015;  // [m]
  const Vec3 centre = middle(line.points);
  for (const int v : members) {
    if (folds.layers_below(v) == 0) continue;
    const Vec3 d = positions[v] - centre;
    const Vec3 out = d - dot(d, line.axis) * line.axis;
    if (norm(out) > 1e-3) positions[v] += folds.layers_below(v) * layer / norm(out) * out;
  }
}

}  // namespace

void place_worn(const RestMesh& rest, const PleatFolds& folds, const std::vector<int>& members,
                std::vector<HungLine> hung, const Body& body, std::vector<Vec3>& positions) {
  const std::size_t n = positions.size();
  turn_to_each_other(rest, hung);
  run_between_other_lines(hung);
  const double clearance = std::clamp(0.1 * rest.mean_edge(), 0.001, 0.004);
  std::vector<bool> in_component(n, false);
  for (const int v : members) in_component[v] = true;
  std::vector<std::vector<double>> depth;
  depth.reserve(hung.size());
  for (const HungLine& h : hung) depth.push_back(rest.distance_from(h.chain.vertices));
  std::vector<int> line_of = assign(rest, members, hung, depth);
  assign_legs(rest, members, hung, line_of);

  std::vector<bool> free = in_component;
  for (const HungLine& h : hung) {
    for (std::size_t i = 0; i < h.chain.vertices.size(); ++i) {
      positions[h.chain.vertices[i]] = h.chain.positions[i];
      free[h.chain.vertices[i]] = false;
    }
  }
  for (std::size_t l = 0; l < hung.size(); ++l) {
    const HangingChain& chain = hung[l].chain;
    if (runs_along_axis(*hung[l].line)) {
      place_leg(rest, hung, static_cast<int>(l), line_of, body, clearance, positions);
      continue;
    }
    std::vector<bool> own(n, false);
    for (const int v : members) own[v] = line_of[v] == static_cast<int>(l) && std::isfinite(depth[l][v]);
    const std::optional<std::vector<double>> round_a_tube = tube_winding(rest, chain, own);
    std::vector<double> fraction = round_a_tube ? *round_a_tube : winding(rest, chain, depth[l], in_component);
    folds.fold(rest, chain, own, fraction);
    const Fullness fullness = measure_fullness(rest, fraction, depth[l], own, chain.curve.length());
    const Envelope envelope(*hung[l].line, chain.curve, fullness, body, clearance);
    for (const int v : members) {
      if (own[v] && free[v]) positions[v] = envelope.at(depth[l][v], fraction[v]);
    }
    if (!folds.empty()) lift_layers(folds, members, *hung[l].line, positions);
  }
  relax(rest, free, relaxing_passes, &body, clearance, positions);
  push_out(rest, free, body, clearance, positions);
}

}  // namespace toile
