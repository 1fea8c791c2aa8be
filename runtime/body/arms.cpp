#include <algorithm>
#include <cmath>

#include "runtime/body/limb_rings.hpp"
#include "runtime/body/limbs.hpp"

namespace toile {
namespace {

constexpr double tallness = 1.3;              // of the armhole: height over width
constexpr double stand_off = 0.016;           // [m] of the root ring from the trunk's side
constexpr double stump_ring_spacing = 0.016;  // [m] along the stump
constexpr int shoulder_blend_rings = 3;
constexpr int blend_margin = 3;  // rows and columns of the trunk around the opening that give way

// The height of an ellipse of that girth and tallness.
double ellipse_height(double girth) {
  const std::vector<Vec3> ring = limb_ring({{}, {1, 0, 0}}, 64, girth, tallness);
  return ring[16].z - ring[48].z;
}

Vec3 side_point(const Trunk& trunk, int row, const HalfForm& form) {
  return form.points[trunk.rows[row][trunk.side()]];
}

// The row at which the shoulder ends: coming down from the neck, the side runs outwards faster than down for a while.
int shoulder_row(const Trunk& trunk, const HalfForm& form) {
  bool on_shoulder = false;
  for (int r = static_cast<int>(trunk.rows.size()) - 1; r > 0; --r) {
    const Vec3 step = side_point(trunk, r - 1, form) - side_point(trunk, r, form);
    const bool slopes = step.x > -step.z;
    if (on_shoulder && !slopes) return r;
    on_shoulder = on_shoulder || slopes;
  }
  return -1;
}

// The opening's rim from the middle of its front upwards: as a limb's loops run.
std::vector<int> rim_of(const Trunk& trunk, const Opening& o) {
  std::vector<int> rim;
  const int middle = (o.first_row + o.last_row) / 2;
  for (int r = middle; r < o.last_row; ++r) rim.push_back(trunk.rows[r][o.first_column]);
  for (int c = o.first_column; c < o.last_column; ++c) rim.push_back(trunk.rows[o.last_row][c]);
  for (int r = o.last_row; r > o.first_row; --r) rim.push_back(trunk.rows[r][o.last_column]);
  for (int c = o.last_column; c > o.first_column; --c) rim.push_back(trunk.rows[o.first_row][c]);
  for (int r = o.first_row; r < middle; ++r) rim.push_back(trunk.rows[r][o.first_column]);
  return rim;
}

void free_surroundings(const Trunk& trunk, const Opening& o, HalfForm& form) {
  const int top = std::min(o.last_row + blend_margin, static_cast<int>(trunk.rows.size()) - 1);
  for (int r = std::max(0, o.first_row - blend_margin); r <= top; ++r) {
    for (int c = std::max(1, o.first_column - blend_margin);
         c <= std::min(trunk.columns() - 2, o.last_column + blend_margin); ++c) {
      if (!trunk.is_named[r] || (r > o.first_row && r < o.last_row)) form.free[trunk.rows[r][c]] = true;
    }
  }
}

double smooth_step(double t) {
  return t * t * (3 - 2 * t);
}

}  // namespace

std::optional<Opening> armhole(const Trunk& trunk, const BodyLimb& arm, const HalfForm& form) {
  Opening o;
  o.last_row = shoulder_row(trunk, form);
  if (o.last_row < 0) return std::nullopt;
  const double height = ellipse_height(arm.girth_root);
  const Vec3 top = side_point(trunk, o.last_row, form);
  o.first_row = o.last_row;
  while (o.first_row > 0 && distance(top, side_point(trunk, o.first_row, form)) < height) --o.first_row;
  if ((o.last_row - o.first_row) % 2 != 0) ++o.first_row;  // the rim's count must be a multiple of four
  if (o.first_row < 3 || o.last_row - o.first_row < 4) return std::nullopt;

  const auto& middle = trunk.rows[(o.first_row + o.last_row) / 2];
  double spacing = 0;
  for (int c = 0; c + 1 < trunk.columns(); ++c) {
    spacing += distance(form.points[middle[c]], form.points[middle[c + 1]]) / (trunk.columns() - 1);
  }
  const int reach = static_cast<int>(std::lround(0.5 * height / tallness / spacing));
  const int half_width = std::clamp(reach, 1, trunk.side() - 3);
  o.first_column = trunk.side() - half_width;
  o.last_column = trunk.side() + half_width;
  return o;
}

Limb grow_arm(const Trunk& trunk, const Opening& opening, const BodyLimb& arm, HalfForm& form) {
  const std::vector<int> rim = rim_of(trunk, opening);
  const int count = static_cast<int>(rim.size());
  free_surroundings(trunk, opening, form);

  const Vec3 top = side_point(trunk, opening.last_row, form);
  const Vec3 bottom = side_point(trunk, opening.first_row, form);
  const Vec3 rise = normalized(Vec3{top.x - bottom.x, 0, top.z - bottom.z});
  const double leaving = std::atan2(rise.z, rise.x);  // angle from straight down of the armhole's outward normal
  LimbFrame frame{0.5 * (top + bottom), {std::sin(leaving), 0, -std::cos(leaving)}};
  frame.centre += stand_off * frame.along;

  const std::vector<int> root = form.add(limb_ring(frame, count, arm.girth_root, tallness));
  blend_loops(rim, root, shoulder_blend_rings, form);
  std::vector<int> above = root;
  const int rings = std::max(2, static_cast<int>(std::lround(arm.length / stump_ring_spacing)));
  for (int k = 1; k <= rings; ++k) {
    const double t = smooth_step(static_cast<double>(k) / rings);
    const double angle = leaving + (arm.angle - leaving) * t;
    frame.along = {std::sin(angle), 0, -std::cos(angle)};
    frame.centre += arm.length / rings * frame.along;
    const double girth = arm.girth_root + (arm.girth_tip - arm.girth_root) * t;
    const std::vector<int> ring = form.add(limb_ring(frame, count, girth, tallness + (1 - tallness) * t));
    form.join_loops(ring, above);
    above = ring;
  }
  cap_limb(above, frame, form);
  return {root, {std::sin(arm.angle), 0, -std::cos(arm.angle)}};
}

}  // namespace toile
