#include "runtime/place/worn_component.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/place/envelope.hpp"
#include "runtime/place/relax.hpp"
#include "runtime/place/winding.hpp"

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

// The line that each member hangs from.
std::vector<int> assign(const std::vector<int>& members, const std::vector<HungLine>& hung,
                        const std::vector<std::vector<double>>& depth, std::size_t vertex_count) {
  const int lines = static_cast<int>(hung.size());
  std::vector<int> line_of(vertex_count, -1);
  for (const int v : members) {
    int nearest = 0;
    for (int l = 1; l < lines; ++l) {
      if (depth[l][v] < depth[nearest][v]) nearest = l;
    }
    line_of[v] = nearest;
  }
  // Between two lines one of which hangs below the other, cloth belongs to the upper.
  for (int upper = 0; upper < lines; ++upper) {
    for (int lower = 0; lower < lines; ++lower) {
      const Vec3 way = middle(hung[lower].chain.positions) - middle(hung[upper].chain.positions);
      const double distance_along = dot(hung[upper].line->axis, way);
      if (upper == lower || distance_along < 0.5 * norm(way)) continue;
      const double limit = mean_over(hung[lower].chain.vertices, depth[upper]);
      for (const int v : members) {
        if (line_of[v] == lower && depth[upper][v] < limit) line_of[v] = upper;
      }
    }
  }
  for (int l = 0; l < lines; ++l) {
    for (const int v : hung[l].chain.vertices) line_of[v] = l;
  }
  return line_of;
}

Fullness fullness_of(const RestMesh& rest, const HungLine& hung, const std::vector<double>& depth,
                     const std::vector<double>& fraction, const std::vector<bool>& own) {
  Fullness fullness;
  for (std::size_t v = 0; v < own.size(); ++v) {
    if (own[v]) fullness.depth = std::max(fullness.depth, depth[v]);
  }
  fullness.bin = std::max(1.5 * rest.mean_edge(), fullness.depth / 200);
  const int bins = static_cast<int>(fullness.depth / fullness.bin) + 1;
  const std::vector<double> rough =
      turn_lengths(rest, fraction, depth, own, fullness.bin, bins, hung.chain.curve.length());
  for (int i = 0; i < bins; ++i) {
    const int reach = std::min({2, i, bins - 1 - i});
    double sum = 0;
    for (int j = i - reach; j <= i + reach; ++j) sum += rough[j];
    fullness.turn.push_back(sum / (2 * reach + 1));
  }
  return fullness;
}

}  // namespace

void place_worn(const RestMesh& rest, const std::vector<int>& members, const std::vector<HungLine>& hung,
                const Body& body, std::vector<Vec3>& positions) {
  const std::size_t n = positions.size();
  const double clearance = std::clamp(0.1 * rest.mean_edge(), 0.001, 0.004);
  std::vector<bool> in_component(n, false);
  for (const int v : members) in_component[v] = true;
  std::vector<std::vector<double>> depth;
  depth.reserve(hung.size());
  for (const HungLine& h : hung) depth.push_back(rest.distance_from(h.chain.vertices));
  const std::vector<int> line_of = assign(members, hung, depth, n);

  std::vector<bool> free = in_component;
  for (std::size_t l = 0; l < hung.size(); ++l) {
    const HangingChain& chain = hung[l].chain;
    const std::vector<double> fraction = winding(rest, chain, depth[l], in_component);
    std::vector<bool> own(n, false);
    for (const int v : members) own[v] = line_of[v] == static_cast<int>(l) && std::isfinite(depth[l][v]);
    const Fullness fullness = fullness_of(rest, hung[l], depth[l], fraction, own);
    const Envelope envelope(*hung[l].line, chain.curve, fullness, body, clearance);
    for (const int v : members) {
      if (own[v]) positions[v] = envelope.at(depth[l][v], fraction[v]);
    }
  }
  for (const HungLine& h : hung) {
    for (std::size_t i = 0; i < h.chain.vertices.size(); ++i) {
      positions[h.chain.vertices[i]] = h.chain.positions[i];
      free[h.chain.vertices[i]] = false;
    }
  }
  relax(rest, free, relaxing_passes, &body, clearance, positions);
  push_out(rest, free, body, clearance, positions);
}

}  // namespace toile
