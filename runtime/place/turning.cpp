#include "runtime/place/turning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "runtime/place/winding.hpp"
#include "runtime/place/worn_legs.hpp"

namespace toile {
namespace {

constexpr double least_turn = 1.0 / 12;  // of a ring: less is how the garment is cut
constexpr double distinct = 0.6;         // of the farthest distance, below which the nearest one says something

/// The fraction of the ring that is nearest in the cloth to where distances are from, if any is nearer than the rest.
std::optional<double> nearest_fraction(const HangingChain& ring, const std::vector<double>& distance) {
  std::size_t nearest = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
    const double at = distance[ring.vertices[i]];
    if (!std::isfinite(at)) return std::nullopt;
    if (at < distance[ring.vertices[nearest]]) nearest = i;
    farthest = std::max(farthest, at);
  }
  if (distance[ring.vertices[nearest]] > distinct * farthest) return std::nullopt;
  return ring.fractions[nearest];
}

double nearest_fraction(const BodyLine& line, const BodyLine& other) {
  Vec3 nearest;
  double least = 1e300;
  for (const Vec3& p : line.points) {
    for (const Vec3& o : other.points) {
      if (distance(p, o) >= least) continue;
      least = distance(p, o);
      nearest = p;
    }
  }
  return ClosedCurve(line.points).fraction_near(nearest);
}

}  // namespace

void turn_to_each_other(const RestMesh& rest, std::vector<HungLine>& hung) {
  if (hung.size() < 2) return;
  std::vector<std::vector<double>> distances;
  for (const HungLine& h : hung) distances.push_back(rest.distance_from(h.chain.vertices));
  for (std::size_t l = 0; l < hung.size(); ++l) {
    HangingChain& ring = hung[l].chain;
    if (ring.worn == nullptr || !ring.worn->closed || runs_along_axis(*hung[l].line)) continue;
    double c = 0, s = 0;
    for (std::size_t other = 0; other < hung.size(); ++other) {
      if (other == l || runs_along_axis(*hung[other].line)) continue;
      const std::optional<double> is = nearest_fraction(ring, distances[other]);
      if (!is) continue;
      const double turn = 2 * std::numbers::pi * (nearest_fraction(*hung[l].line, *hung[other].line) - *is);
      c += std::cos(turn);
      s += std::sin(turn);
    }
    const double turn = std::atan2(s, c) / (2 * std::numbers::pi);
    if (std::abs(turn) < least_turn || std::hypot(c, s) < distinct) continue;
    for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
      ring.fractions[i] += turn;
      ring.positions[i] = ring.curve.at(ring.fractions[i]);
    }
  }
}

}  // namespace toile
