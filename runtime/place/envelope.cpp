#include "runtime/place/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

constexpr int generators = 72;
constexpr int most_rings = 160;
constexpr double least_step = 0.008;                     // [m]
constexpr double most_spread = 0.985;                    // sine of the steepest slope away from the axis
constexpr double most_narrowing = -0.5;                  // and towards it
constexpr double evasion = 10 * std::numbers::pi / 180;  // turned outwards at a time to find a way
constexpr double last_evasion = 150 * std::numbers::pi / 180;
constexpr int taut_passes = 3;

struct Generator {
  Vec3 at;
  Vec3 outwards;     // unit, across the axis
  Vec3 from_middle;  // across the axis from the ring's middle, 1 in the mean: what narrows the ring keeps its shape
};

std::vector<Generator> start_generators(const BodyLine& line, const ClosedCurve& start) {
  const BodyLine widened{line.name, start.points(), start.length(), line.axis};
  const std::vector<Vec3> outward = outward_directions(widened);
  std::vector<Generator> result;
  result.reserve(generators);
  for (int k = 0; k < generators; ++k) {
    const Vec3 at = start.at(static_cast<double>(k) / generators);
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < outward.size(); ++i) {
      if (distance(start.points()[i], at) < distance(start.points()[nearest], at)) nearest = i;
    }
    result.push_back({at, outward[nearest], {}});
  }
  for (int pass = 0; pass < 2; ++pass) {  // nearest points are a little uneven
    const std::vector<Generator> before = result;
    for (int k = 0; k < generators; ++k) {
      const Vec3 sum = before[(k + generators - 1) % generators].outwards + before[k].outwards +
                       before[(k + 1) % generators].outwards;
      if (norm(sum) > 0.1) result[k].outwards = normalized(sum);
    }
  }
  return result;
}

std::vector<Vec3> positions(const std::vector<Generator>& ring) {
  std::vector<Vec3> points;
  points.reserve(ring.size());
  for (const Generator& g : ring) points.push_back(g.at);
  return points;
}

void find_middle(std::vector<Generator>& ring, Vec3 axis) {
  Vec3 middle;
  for (const Generator& g : ring) middle += g.at / static_cast<double>(generators);
  double mean = 0;
  for (Generator& g : ring) {
    const Vec3 d = g.at - middle;
    g.from_middle = d - dot(d, axis) * axis;
    mean += norm(g.from_middle) / generators;
  }
  for (Generator& g : ring) g.from_middle = g.from_middle / std::max(mean, 1e-6);
}

// One ring further.
class March {
 public:
  March(const Body& body, Vec3 axis, double step, double clearance)
      : body_(body), axis_(axis), step_(step), clearance_(clearance) {}

  void go(std::vector<Generator>& ring, double spread) const {
    find_middle(ring, axis_);
    const double free_angle = std::asin(spread);
    std::vector<double> angles;
    angles.reserve(ring.size());
    for (const Generator& g : ring) angles.push_back(way_out(g, free_angle));
    for (int pass = 0; pass < taut_passes; ++pass) {
      const std::vector<double> before = angles;
      for (int k = 0; k < generators; ++k) {
        const double between = 0.5 * (before[(k + generators - 1) % generators] + before[(k + 1) % generators]);
        if (between > before[k]) angles[k] = way_out(ring[k], between);
      }
    }
    for (int k = 0; k < generators; ++k) ring[k].at = ahead(ring[k], angles[k]);
  }

 private:
  Vec3 ahead(const Generator& g, double angle) const {
    return g.at + step_ * (std::sin(angle) * (angle < 0 ? g.from_middle : g.outwards) + std::cos(angle) * axis_);
  }
  bool is_clear(const Generator& g, double angle) const { return !body_.nearest(ahead(g, angle), clearance_); }

  // The least turn outwards from `angle` that leads out of the body.
  double way_out(const Generator& g, double angle) const {
    if (is_clear(g, angle)) return angle;
    double blocked = angle, clear = angle;
    while (clear < last_evasion) {
      clear = std::min(clear + evasion, last_evasion);
      if (is_clear(g, clear)) break;
      blocked = clear;
    }
    for (int i = 0; i < 4; ++i) {
      const double middle = 0.5 * (blocked + clear);
      (is_clear(g, middle) ? clear : blocked) = middle;
    }
    return clear;
  }

  const Body& body_;
  Vec3 axis_;
  double step_;
  double clearance_;
};

}  // namespace

Envelope::Envelope(const BodyLine& line, const ClosedCurve& start, const Fullness& fullness, const Body& body,
                   double clearance)
    : step_(std::max(least_step, fullness.depth / most_rings)) {
  std::vector<Generator> ring = start_generators(line, start);
  const March march(body, line.axis, step_, clearance);
  rings_.emplace_back(positions(ring));
  const int count = static_cast<int>(std::ceil(fullness.depth / step_)) + 1;
  double spread = 0;
  for (int i = 1; i <= count; ++i) {
    // Aim a few rings ahead: the slope changes gently, and what one ring missed the next make up for.
    constexpr int ahead = 3;
    const double missing = fullness.turn_at((i - 1 + ahead) * step_) - rings_.back().length();
    const double wanted = missing / (2 * std::numbers::pi * ahead * step_);
    spread = i == 1 ? wanted : 0.5 * (spread + wanted);
    spread = std::clamp(spread, most_narrowing, most_spread);
    march.go(ring, spread);
    rings_.emplace_back(positions(ring));
  }
}

Vec3 Envelope::at(double depth, double fraction) const {
  const double x = std::clamp(depth / step_, 0.0, static_cast<double>(rings_.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(x), rings_.size() - 2);
  const double t = x - static_cast<double>(i);
  return (1 - t) * rings_[i].at(fraction) + t * rings_[i + 1].at(fraction);
}

}  // namespace toile
