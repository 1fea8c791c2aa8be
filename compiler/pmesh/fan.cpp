#include "compiler/pmesh/fan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

using std::numbers::pi;
constexpr int kMostRings = 64;
constexpr double kWide = 1.3;        // of a side: sectors of this width need no pins
constexpr double kApart = 0.5;       // of a sector or side, between pins
constexpr double kClearance = 0.25;  // of a sector or side, whichever is smaller

/// The distance from the outline, negative outside.
double clearance(const Loops& loops, Vec2 p) {
  double nearest = 1e300;
  bool inside = false;
  for (const auto& nodes : loops) {
    for (std::size_t i = 0, j = nodes.size() - 1; i < nodes.size(); j = i++) {
      const Vec2 a = nodes[i], b = nodes[j];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
      const double along = std::clamp(dot(p - a, b - a) / std::max(dot(b - a, b - a), 1e-300), 0.0, 1.0);
      nearest = std::min(nearest, distance(p, a + along * (b - a)));
    }
  }
  return inside ? nearest : -nearest;
}

}  // namespace

void add_fan(PlaneDomain& domain, int loop, int node, int sectors) {
  const auto& nodes = domain.loops[loop];
  const int n = static_cast<int>(nodes.size());
  const auto at = [&](int i) { return nodes[(i % n + n) % n]; };
  const Vec2 tip = at(node);
  for (int ring = 1; ring <= kMostRings && 2 * ring < n; ++ring) {
    const Vec2 first = at(node + ring) - tip, last = at(node - ring) - tip;
    double angle = std::atan2(cross(first, last), dot(first, last));
    if (angle <= 0) angle += 2 * pi;
    const double side =
        std::max(distance(at(node + ring), at(node + ring - 1)), distance(at(node - ring), at(node - ring + 1)));
    const double width = angle / sectors * std::sqrt(norm(first) * norm(last));
    if (ring > 1 && width > kWide * side) return;
    for (int k = 1; k < sectors; ++k) {
      // Joined by a Delaunay triangulation, as they lie nearly on a circle about the tip.
      const double part = static_cast<double>(k) / sectors;
      const double radius = std::pow(norm(first), 1 - part) * std::pow(norm(last), part);
      const Vec2 pin = tip + radius * direction(std::atan2(first.y, first.x) + part * angle);
      const double least = std::min(width, side);
      // Fans of two folds beside each other reach over the same cloth.
      const bool is_new = std::none_of(domain.pins.begin(), domain.pins.end(),
                                       [&](Vec2 other) { return distance(other, pin) < kApart * least; });
      if (is_new && clearance(domain.loops, pin) > kClearance * least) domain.pins.push_back(pin);
    }
  }
}

}  // namespace toile
