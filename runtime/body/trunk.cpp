#include "runtime/body/trunk.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/body/superellipse.hpp"

namespace toile {
namespace {

constexpr int ring_vertices = 60;
constexpr double row_spacing = 0.0185;  // [m]

template <class Get>
MonotoneCubic interpolate(const std::vector<BodySection>& sections, Get get) {
  std::vector<double> levels, values;
  for (const BodySection& section : sections) {
    levels.push_back(section.level);
    values.push_back(get(section));
  }
  return {levels, values};
}

// How far the surface runs between two levels: the most of what it does at the front, the side and the back.
double run(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  const std::size_t quarter = a.size() / 4;
  return std::max({distance(a[0], b[0]), distance(a[quarter], b[quarter]), distance(a[2 * quarter], b[2 * quarter])});
}

std::vector<double> row_levels_between(const TrunkProfile& profile, double from, double to) {
  constexpr int steps = 12;
  std::vector<double> arc{0};
  for (int i = 0; i < steps; ++i) {
    const double z0 = from + (to - from) * i / steps;
    const double z1 = from + (to - from) * (i + 1) / steps;
    arc.push_back(arc.back() + run(profile.ring(z0, 8), profile.ring(z1, 8)));
  }
  const int rows = std::max(1, static_cast<int>(std::lround(arc.back() / row_spacing)));
  std::vector<double> levels;
  std::size_t j = 0;
  for (int k = 1; k < rows; ++k) {
    const double s = arc.back() * k / rows;
    while (arc[j + 1] < s) ++j;
    const double t = (s - arc[j]) / (arc[j + 1] - arc[j]);
    levels.push_back(from + (to - from) * (static_cast<double>(j) + t) / steps);
  }
  return levels;
}

std::vector<int> add_row(const TrunkProfile& profile, double level, HalfForm& form) {
  std::vector<Vec3> ring = profile.ring(level, ring_vertices);
  ring.resize(ring_vertices / 2 + 1);
  ring.front().x = ring.back().x = 0;
  return form.add(ring);
}

}  // namespace

TrunkProfile::TrunkProfile(const std::vector<BodySection>& sections)
    : girth_(interpolate(sections, [](const BodySection& s) { return s.girth; })),
      ratio_(interpolate(sections, [](const BodySection& s) { return s.width_to_depth; })),
      forward_(interpolate(sections, [](const BodySection& s) { return s.forward; })),
      squareness_(interpolate(sections, [](const BodySection& s) { return s.squareness; })) {}

std::vector<Vec3> TrunkProfile::ring(double level, int count) const {
  std::vector<Vec3> ring;
  ring.reserve(static_cast<std::size_t>(count));
  for (const Vec3& p : superellipse(count, girth_.at(level), ratio_.at(level), squareness_.at(level))) {
    ring.push_back({p.x, p.y - forward_.at(level), level});
  }
  return ring;
}

Trunk lay_out_trunk(const std::vector<BodySection>& sections, HalfForm& form) {
  const TrunkProfile profile(sections);
  Trunk trunk;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (i > 0) {
      for (const double level : row_levels_between(profile, sections[i - 1].level, sections[i].level)) {
        trunk.rows.push_back(add_row(profile, level, form));
        trunk.is_named.push_back(false);
      }
    }
    trunk.row_of_section.push_back(static_cast<int>(trunk.rows.size()));
    trunk.rows.push_back(add_row(profile, sections[i].level, form));
    trunk.is_named.push_back(!sections[i].name.empty());
  }
  return trunk;
}

void skin_trunk(const Trunk& trunk, const Opening& opening, HalfForm& form) {
  for (int r = 0; r + 1 < static_cast<int>(trunk.rows.size()); ++r) {
    const auto& lower = trunk.rows[r];
    const auto& upper = trunk.rows[r + 1];
    for (int c = 0; c + 1 < trunk.columns(); ++c) {
      const bool open =
          r >= opening.first_row && r < opening.last_row && c >= opening.first_column && c < opening.last_column;
      if (!open) form.quad(lower[c], lower[c + 1], upper[c], upper[c + 1]);
    }
  }
}

void cap_trunk(const std::vector<int>& rim, bool upwards, HalfForm& form) {
  constexpr int rings = 4;
  constexpr double flatness = 0.35;  // height of the dome over the radius of the rim
  Vec3 centre = 0.5 * (form.points[rim.front()] + form.points[rim.back()]);
  centre.x = 0;
  const double rise = (upwards ? 1 : -1) * flatness * 0.5 * distance(form.points[rim.front()], form.points[rim.back()]);
  std::vector<int> outer = rim;
  for (int k = 1; k < rings; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / rings;
    std::vector<Vec3> ring;
    ring.reserve(rim.size());
    for (const int v : rim) {
      ring.push_back(centre + std::cos(angle) * (form.points[v] - centre) + Vec3{0, 0, rise * std::sin(angle)});
    }
    ring.front().x = ring.back().x = 0;
    const std::vector<int> inner = form.add(ring);
    if (upwards)
      form.join_strips(outer, inner);
    else
      form.join_strips(inner, outer);
    outer = inner;
  }
  const int pole = form.add({0, centre.y, centre.z + rise});
  for (std::size_t i = 0; i + 1 < outer.size(); ++i) {
    if (upwards)
      form.triangles.push_back({outer[i], outer[i + 1], pole});
    else
      form.triangles.push_back({outer[i + 1], outer[i], pole});
  }
}

}  // namespace toile
