#include "runtime/render/yarns.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace toile {
namespace {

/// A fixed number in [-1, 1] for a cell of a grid.
double cell_value(std::int64_t i, std::int64_t j, std::uint64_t system) {
  std::uint64_t x = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u ^
                    static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fu ^ system * 0x165667b19e3779f9u;
  x ^= x >> 29;
  x *= 0xbf58476d1ce4e5b9u;
  x ^= x >> 32;
  return static_cast<double>(x >> 11) * 0x1p-52 - 1;
}

/// One system of yarns: smooth along, each for itself across.
double streak(double along, double across, std::uint64_t system) {
  const double i = std::floor(along);
  const auto yarn = static_cast<std::int64_t>(std::floor(across));
  const double t = along - i;
  const double smooth = t * t * (3 - 2 * t);
  const auto cell = static_cast<std::int64_t>(i);
  return (1 - smooth) * cell_value(cell, yarn, system) + smooth * cell_value(cell + 1, yarn, system);
}

struct Layer {
  double length, width;  // [m] of a streak
  double strength;
};
constexpr Layer kLayers[] = {{0.030, 0.0009, 0.045}, {0.080, 0.0031, 0.022}};

}  // namespace

double yarn_shade(Vec2 uv, Vec2 footprint) {
  // Beyond this a place on a cloth is not a place, and the grid's integers end.
  constexpr double kFar = 1e6;
  if (!(std::abs(uv.x) < kFar && std::abs(uv.y) < kFar)) return 1;
  double shade = 1;
  std::uint64_t system = 1;
  for (const Layer& layer : kLayers) {
    const auto shown = [&](double width) { return layer.strength * std::clamp(2 - width / layer.width, 0.0, 1.0); };
    shade += shown(footprint.y) * streak(uv.x / layer.length, uv.y / layer.width, system++);
    shade += shown(footprint.x) * streak(uv.y / layer.length, uv.x / layer.width, system++);
  }
  return shade;
}

}  // namespace toile
