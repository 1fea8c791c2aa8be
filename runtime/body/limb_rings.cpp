#include "runtime/body/limb_rings.hpp"

#include <cmath>
#include <numbers>

#include "runtime/body/superellipse.hpp"

namespace toile {

Vec3 LimbFrame::up() const {
  return {-along.z, 0, along.x};
}

std::vector<Vec3> limb_ring(const LimbFrame& frame, int count, double girth, double ratio) {
  std::vector<Vec3> ring;
  ring.reserve(static_cast<std::size_t>(count));
  for (const Vec3& p : superellipse(count, girth, ratio, 2)) {
    ring.push_back(frame.centre + p.x * frame.up() + Vec3{0, p.y, 0});
  }
  return ring;
}

void blend_loops(const std::vector<int>& upper, const std::vector<int>& lower, int between, HalfForm& form) {
  std::vector<int> above = upper;
  for (int k = 1; k <= between; ++k) {
    const double t = static_cast<double>(k) / (between + 1);
    std::vector<int> ring;
    for (std::size_t i = 0; i < upper.size(); ++i) {
      ring.push_back(form.add((1 - t) * form.points[upper[i]] + t * form.points[lower[i]], true));
    }
    form.join_loops(ring, above);
    above = ring;
  }
  form.join_loops(lower, above);
}

void cap_limb(const std::vector<int>& rim, const LimbFrame& frame, HalfForm& form) {
  constexpr int rings = 4;
  constexpr double flatness = 0.45;
  const double rise = flatness * distance(form.points[rim.front()], frame.centre);
  std::vector<int> outer = rim;
  for (int k = 1; k < rings; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / rings;
    std::vector<Vec3> ring;
    ring.reserve(rim.size());
    for (const int v : rim) {
      ring.push_back(frame.centre + std::cos(angle) * (form.points[v] - frame.centre) +
                     rise * std::sin(angle) * frame.along);
    }
    const std::vector<int> inner = form.add(ring);
    form.join_loops(inner, outer);
    outer = inner;
  }
  const int pole = form.add(frame.centre + rise * frame.along);
  for (std::size_t i = 0; i < outer.size(); ++i) {
    form.triangles.push_back({outer[(i + 1) % outer.size()], outer[i], pole});
  }
}

}  // namespace toile
