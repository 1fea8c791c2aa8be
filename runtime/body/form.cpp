#include "runtime/body/form.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "runtime/body/limbs.hpp"
#include "runtime/body/trunk.hpp"

namespace toile {
namespace {

constexpr Vec3 down{0, 0, -1};

const BodyLimb* limb(const FormSpec& form, BodyLimb::Kind kind) {
  for (const BodyLimb& candidate : form.limbs) {
    if (candidate.kind == kind) return &candidate;
  }
  return nullptr;
}

std::string section_title(const BodySection& s) {
  return s.name.empty() ? fmt::format("the section at {:.1f} cm", 100 * s.level) : fmt::format("section {}", s.name);
}

std::string section_fault(const FormSpec& form) {
  if (form.sections.size() < 2) return "a form needs two sections at least";
  const BodySection* below = nullptr;
  for (const BodySection& s : form.sections) {
    if (!(std::isfinite(s.level) && std::isfinite(s.forward))) {
      return section_title(s) + " has no finite level and place";
    }
    if (!(s.girth >= 0.05 && s.girth <= 5)) return section_title(s) + " must have a girth from 5 cm to 5 m";
    if (!(s.width_to_depth >= 0.1 && s.width_to_depth <= 10)) {
      return section_title(s) + " must have a ratio of width to depth from 0.1 to 10";
    }
    if (!(s.squareness >= 1.2 && s.squareness <= 10)) {
      return section_title(s) + " must have a squareness from 1.2 to 10";
    }
    if (below != nullptr && !(s.level >= below->level + 1e-3)) {
      return fmt::format("{} must lie above {}: sections are listed upwards", section_title(s), section_title(*below));
    }
    below = &s;
  }
  if (form.sections.back().level - form.sections.front().level > 5) return "a form is 5 m high at most";
  return {};
}

std::string limb_fault(const FormSpec& form) {
  int arms = 0, legs = 0;
  for (const BodyLimb& l : form.limbs) {
    const bool is_arm = l.kind == BodyLimb::Kind::Arm;
    ++(is_arm ? arms : legs);
    const char* title = is_arm ? "limb arm" : "limb leg";
    const auto girth_is_fit = [](double girth) { return girth >= 0.02 && girth <= 3; };
    if (!girth_is_fit(l.girth_root) || !girth_is_fit(l.girth_tip)) {
      return fmt::format("{} must have girths from 2 cm to 3 m", title);
    }
    if (!(l.length >= 0.01 && l.length <= 3)) return fmt::format("{} must have a length from 1 cm to 3 m", title);
    if (!(l.angle >= 0 && l.angle <= (is_arm ? 2.6 : 1.0))) {
      return fmt::format("{} must have an angle from 0 to {} deg", title, is_arm ? 150 : 57);
    }
  }
  if (arms > 1 || legs > 1) return "a form has one limb arm and one limb leg, each mirrored, at most";
  return {};
}

BodyLine line_of(std::string name, std::vector<Vec3> points, Vec3 axis) {
  BodyLine line{std::move(name), std::move(points), 0, axis};
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    line.girth += distance(line.points[i], line.points[(i + 1) % line.points.size()]);
  }
  return line;
}

// A line of the left half and its mirror image, which starts at its own front and runs the same way seen from above.
void add_pair(const std::string& name, const std::vector<Vec3>& left, Vec3 axis, std::vector<BodyLine>& lines) {
  std::vector<Vec3> right;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const Vec3 p = left[(left.size() - i) % left.size()];
    right.push_back({-p.x, p.y, p.z});
  }
  lines.push_back(line_of("left_" + name, left, axis));
  lines.push_back(line_of("right_" + name, right, {-axis.x, axis.y, axis.z}));
}

std::vector<Vec3> points_of(const std::vector<int>& vertices, const HalfForm& half, const WholeForm& whole) {
  std::vector<Vec3> points;
  for (const int v : vertices) {
    const int kept = whole.whole_of_half[v];
    points.push_back(kept >= 0 ? whole.surface.points[kept] : half.points[v]);
  }
  return points;
}

void add_section_lines(const FormSpec& form, const Trunk& trunk, const HalfForm& half, std::vector<BodyLine>& lines) {
  for (std::size_t i = 0; i < form.sections.size(); ++i) {
    if (form.sections[i].name.empty()) continue;
    std::vector<Vec3> ring;
    for (const int v : trunk.rows[trunk.row_of_section[i]]) ring.push_back(half.points[v]);
    for (std::size_t k = ring.size() - 2; k > 0; --k) ring.push_back({-ring[k].x, ring[k].y, ring[k].z});
    lines.push_back(line_of(form.sections[i].name, std::move(ring), down));
  }
}

// Over the left half of the waist to the back centre, down it, along the saddle and up the front centre.
std::vector<int> crotch_line(const Trunk& trunk, int waist_row, const Saddle& saddle) {
  std::vector<int> line = trunk.rows[waist_row];
  for (int r = waist_row - 1; r >= 0; --r) line.push_back(trunk.rows[r].back());
  line.insert(line.end(), saddle.seam.begin(), saddle.seam.end());
  for (int r = 0; r < waist_row; ++r) line.push_back(trunk.rows[r].front());
  return line;
}

}  // namespace

LinedSurface make_form(const FormSpec& form) {
  if (std::string fault = section_fault(form); !fault.empty()) return {{}, {}, std::move(fault)};
  if (std::string fault = limb_fault(form); !fault.empty()) return {{}, {}, std::move(fault)};
  const BodyLimb* arm = limb(form, BodyLimb::Kind::Arm);
  const BodyLimb* leg = limb(form, BodyLimb::Kind::Leg);

  HalfForm half;
  const Trunk trunk = lay_out_trunk(form.sections, half);
  std::optional<Opening> opening;
  if (arm != nullptr) {
    opening = armhole(trunk, *arm, half);
    if (!opening) {
      return {{},
              {},
              "the sections leave no room for the arms: they need shoulders that slope from a narrower neck, "
              "and the height of the armhole below"};
    }
  }
  skin_trunk(trunk, opening.value_or(Opening{}), half);
  cap_trunk(trunk.rows.back(), true, half);
  std::optional<Limb> left_arm, left_leg;
  Saddle saddle;
  if (opening) left_arm = grow_arm(trunk, *opening, *arm, half);
  if (leg != nullptr) {
    saddle = hang_saddle(trunk, half);
    left_leg = grow_leg(saddle, *leg, half);
  } else {
    cap_trunk(trunk.rows.front(), false, half);
  }

  WholeForm whole = complete(half);
  LinedSurface result;
  add_section_lines(form, trunk, half, result.lines);
  if (left_arm) add_pair("armhole", points_of(left_arm->root, half, whole), left_arm->axis, result.lines);
  if (left_leg) {
    add_pair("leg", points_of(left_leg->root, half, whole), left_leg->axis, result.lines);
    for (std::size_t i = 0; i < form.sections.size(); ++i) {
      if (form.sections[i].name != "waist") continue;
      add_pair("crotch", points_of(crotch_line(trunk, trunk.row_of_section[i], saddle), half, whole), left_leg->axis,
               result.lines);
    }
  }
  result.surface = std::move(whole.surface);
  return result;
}

}  // namespace toile
