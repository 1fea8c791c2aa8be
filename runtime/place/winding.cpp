#include "runtime/place/winding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/solve/sparse.hpp"

namespace toile {
namespace {

constexpr double least_weight = 0.02;  // of an edge: obtuse triangles must not make the problem indefinite

// Half the sum of the cotangents opposite to each edge, in the cloth at rest.
std::vector<double> edge_weights(const Cloth& cloth) {
  std::vector<double> weights;
  weights.reserve(cloth.edges.size());
  for (const SMesh::Edge& edge : cloth.edges) {
    double weight = 0;
    for (const SMesh::Wing& wing : edge.wings) {
      const auto& uv = cloth.triangles[wing.triangle].uv;
      const Vec2 a = uv[(wing.corner + 1) % 3] - uv[wing.corner], b = uv[(wing.corner + 2) % 3] - uv[wing.corner];
      weight += 0.5 * dot(a, b) / std::max(std::abs(cross(a, b)), 1e-12);
    }
    weights.push_back(std::max(weight, least_weight));
  }
  return weights;
}

// A first guess that winds as it should: each vertex, in the order of their distances from the chain, takes the mean of
// its neighbours before it, as points on a circle (the paper's layers, one vertex thick).
void spread_by_layers(const RestMesh& rest, const std::vector<double>& depth, const std::vector<bool>& in_component,
                      std::vector<bool> known, std::vector<double>& fraction) {
  std::vector<int> order;
  for (std::size_t v = 0; v < known.size(); ++v) {
    if (in_component[v] && !known[v]) order.push_back(static_cast<int>(v));
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth[a] < depth[b]; });
  for (const int v : order) {
    double c = 0, s = 0;
    for (const int index : rest.triangles_at(v)) {
      for (const int w : rest.cloth().triangles[index].vertices) {
        if (!known[w]) continue;
        c += std::cos(2 * std::numbers::pi * fraction[w]);
        s += std::sin(2 * std::numbers::pi * fraction[w]);
      }
    }
    fraction[v] = std::atan2(s, c) / (2 * std::numbers::pi);
    known[v] = true;
  }
}

}  // namespace

std::vector<double> harmonic_correction(const Cloth& cloth, const std::vector<bool>& unknown,
                                        const std::vector<double>& source,
                                        const std::function<double(int, int)>& difference) {
  const std::size_t n = unknown.size();
  std::vector<int> row(n, -1);
  int count = 0;
  for (std::size_t v = 0; v < n; ++v) {
    if (unknown[v]) row[v] = count++;
  }
  std::vector<double> correction(n, 0.0);
  if (count == 0) return correction;
  const std::vector<double> weights = edge_weights(cloth);
  std::vector<std::vector<int>> pairs;
  pairs.reserve(cloth.edges.size());
  for (const SMesh::Edge& edge : cloth.edges) pairs.push_back({edge.vertices[0], edge.vertices[1]});
  SparseMatrix laplacian(row, pairs);
  Vector right = Vector::Zero(static_cast<Eigen::Index>(n));
  for (std::size_t e = 0; e < cloth.edges.size(); ++e) {
    const auto [a, b] = cloth.edges[e].vertices;
    laplacian.add(a, a, weights[e]);
    laplacian.add(b, b, weights[e]);
    laplacian.add(a, b, -weights[e]);
    right(a) += weights[e] * difference(a, b);
    right(b) += weights[e] * difference(b, a);
  }
  for (std::size_t v = 0; v < n; ++v) right(static_cast<Eigen::Index>(v)) += source[v];
  Cholesky cholesky;
  cholesky.analyse(laplacian);
  if (!cholesky.factorise(laplacian)) return correction;
  const Vector found = cholesky.solve_free(laplacian, right);
  for (std::size_t v = 0; v < n; ++v) {
    const double value = found(static_cast<Eigen::Index>(v));
    if (row[v] >= 0 && std::isfinite(value)) correction[v] = value;
  }
  return correction;
}

double turn_between(double from, double to) {
  const double d = to - from;
  return d - std::round(d);
}

std::vector<double> winding(const RestMesh& rest, const HangingChain& chain, const std::vector<double>& depth,
                            const std::vector<bool>& in_component) {
  const Cloth& cloth = rest.cloth();
  const std::size_t n = in_component.size();
  std::vector<double> fraction(n, 0.0);
  std::vector<bool> known(n, false);
  for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
    known[chain.vertices[i]] = true;
    fraction[chain.vertices[i]] = chain.fractions[i];
  }
  std::vector<bool> unknown(n, false);
  for (std::size_t v = 0; v < n; ++v) unknown[v] = in_component[v] && !known[v];
  spread_by_layers(rest, depth, in_component, known, fraction);
  // What has to be added to make it harmonic is single-valued, and zero on the chain.
  const std::vector<double> added = harmonic_correction(cloth, unknown, std::vector<double>(n, 0.0), [&](int v, int w) {
    return turn_between(fraction[v], fraction[w]);
  });
  for (std::size_t v = 0; v < n; ++v) fraction[v] += added[v];
  return fraction;
}

std::vector<double> turn_lengths(const RestMesh& rest, const std::vector<double>& fraction,
                                 const std::vector<double>& depth, const std::vector<bool>& counted, double width,
                                 int bins, double at_chain) {
  std::vector<double> area(static_cast<std::size_t>(bins), 0.0), turning(area);
  for (const ClothTriangle& t : rest.cloth().triangles) {
    const auto& [a, b, c] = t.vertices;
    if (!counted[a] || !counted[b] || !counted[c]) continue;
    const Vec2 x = t.uv[1] - t.uv[0], y = t.uv[2] - t.uv[0];
    const double twice_area = cross(x, y);
    if (!(std::abs(twice_area) > 0)) continue;
    const double fx = turn_between(fraction[a], fraction[b]), fy = turn_between(fraction[a], fraction[c]);
    const Vec2 gradient = (fx * perpendicular(-y) + fy * perpendicular(x)) / twice_area;
    const int bin = std::clamp(static_cast<int>((depth[a] + depth[b] + depth[c]) / 3 / width), 0, bins - 1);
    area[bin] += std::abs(twice_area);
    turning[bin] += std::abs(twice_area) * norm(gradient);
  }
  std::vector<double> lengths;
  double last = at_chain;
  for (int i = 0; i < bins; ++i) {
    if (turning[i] > 0) last = std::clamp(area[i] / turning[i], 0.2 * at_chain, 12 * at_chain);
    lengths.push_back(last);
  }
  return lengths;
}

}  // namespace toile
