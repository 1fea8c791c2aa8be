#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/body/limb_rings.hpp"
#include "runtime/body/limbs.hpp"

namespace toile {
namespace {

constexpr double saddle_drop = 0.45;    // of the saddle below the lowest ring, over half that ring's depth
constexpr double seam_spacing = 0.020;  // [m] along the saddle
constexpr double gap = 0.020;           // [m] from the middle to the inner side of a leg at its root
constexpr double root_drop = 0.045;     // [m] of the leg's first ring below the saddle
constexpr double ring_spacing = 0.034;  // [m] along the leg
constexpr double taper = 1.4;           // exponent with which the girth falls off towards the tip
constexpr int blend_rings = 5;
constexpr int blend_rows = 3;         // of the trunk that give way, unless they are sections asked for by name
constexpr double rounding_way = 0.3;  // of the leg, over which its rings become circles

// The multiple of the ring's spacing by which a loop is to be turned so that its vertices lie, in the mean, opposite
// those of the ring that starts at its front.
int least_twist(const std::vector<int>& loop, const LimbFrame& frame, const HalfForm& form) {
  const int count = std::max(1, static_cast<int>(loop.size()));
  double c = 0, s = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 d = form.points[loop[i]] - frame.centre;
    const double difference = std::atan2(d.x, -d.y) - 2 * std::numbers::pi * i / count;
    c += std::cos(difference);
    s += std::sin(difference);
  }
  const int steps = static_cast<int>(std::lround(std::atan2(s, c) / (2 * std::numbers::pi) * count));
  return (steps % count + count) % count;
}

// How wide the root of a leg is for its depth, so that two of them and the gap come to the width of the trunk above.
double root_ratio(double girth, double width) {
  double narrow = 0.6, wide = 1.15;
  for (int i = 0; i < 40; ++i) {
    const double ratio = 0.5 * (narrow + wide);
    const std::vector<Vec3> ring = limb_ring({{}, {0, 0, -1}}, 32, girth, ratio);
    (ring[8].x - ring[24].x < width ? narrow : wide) = ratio;
  }
  return narrow;
}

}  // namespace

Saddle hang_saddle(const Trunk& trunk, HalfForm& form) {
  for (int r = 0; r < std::min(blend_rows, static_cast<int>(trunk.rows.size())) && !trunk.is_named[r]; ++r) {
    for (const int v : trunk.rows[r]) form.free[v] = true;
  }
  Saddle saddle{trunk.rows.front(), {}};
  const Vec3 front = form.points[saddle.loop.front()];
  const Vec3 back = form.points[saddle.loop.back()];
  const double half_depth = 0.5 * (back.y - front.y);
  const Vec3 centre = 0.5 * (front + back);
  const double drop = saddle_drop * half_depth;
  const double length = std::numbers::pi * 0.5 * (half_depth + drop);
  int between = std::max(3, static_cast<int>(std::lround(length / seam_spacing)));
  while ((saddle.loop.size() + between) % 4 != 0) ++between;
  for (int k = 1; k <= between; ++k) {
    const double angle = std::numbers::pi * k / (between + 1);
    saddle.seam.push_back(
        form.add({0, centre.y + half_depth * std::cos(angle), centre.z - drop * std::sin(angle)}, true));
  }
  saddle.loop.insert(saddle.loop.end(), saddle.seam.begin(), saddle.seam.end());
  return saddle;
}

Limb grow_leg(const Saddle& saddle, const BodyLimb& leg, HalfForm& form) {
  const int count = static_cast<int>(saddle.loop.size());
  const Vec3 low = form.points[saddle.seam[saddle.seam.size() / 2]];
  const Vec3 axis{std::sin(leg.angle), 0, -std::cos(leg.angle)};
  const double trunk_half_width = form.points[saddle.loop[(saddle.loop.size() - saddle.seam.size()) / 2]].x;
  const double ratio = root_ratio(leg.girth_root, trunk_half_width - gap);
  LimbFrame frame{{0, low.y, low.z - root_drop}, axis};
  frame.centre.x = gap + limb_ring(frame, count, leg.girth_root, ratio)[count / 4].x;

  const std::vector<int> root = form.add(limb_ring(frame, count, leg.girth_root, ratio));
  std::vector<int> opposite = root;
  std::rotate(opposite.begin(), opposite.begin() + least_twist(saddle.loop, frame, form), opposite.end());
  blend_loops(saddle.loop, opposite, blend_rings, form);

  std::vector<int> above = root;
  const int rings = std::max(2, static_cast<int>(std::lround(leg.length / ring_spacing)));
  for (int k = 1; k <= rings; ++k) {
    const double t = static_cast<double>(k) / rings;
    frame.centre += leg.length / rings * axis;
    const double girth = leg.girth_tip + (leg.girth_root - leg.girth_tip) * std::pow(1 - t, taper);
    const double round = std::min(1.0, t / rounding_way);
    const std::vector<int> ring = form.add(limb_ring(frame, count, girth, ratio + (1 - ratio) * round));
    form.join_loops(ring, above);
    above = ring;
  }
  cap_limb(above, frame, form);
  return {root, axis};
}

}  // namespace toile
