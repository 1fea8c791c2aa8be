#include "tests/garments/random_outline.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace toile::test {

using std::numbers::pi;

std::string cm(double metres) {
  return fmt::format("{:.8g}cm", 100 * metres);
}

double Outline::chord(int edge) const {
  const OutlineEdge& from = edges_[static_cast<std::size_t>(edge)];
  const OutlineEdge& to = edges_[static_cast<std::size_t>((edge + 1) % count())];
  return std::hypot(to.x - from.x, to.y - from.y);
}

double Outline::length(int edge) const {
  const double chord = this->chord(edge), bulge = std::abs(edges_[static_cast<std::size_t>(edge)].bulge);
  if (bulge == 0) return chord;
  const double radius = (chord * chord / 4 + bulge * bulge) / (2 * bulge);
  return 2 * radius * std::asin(chord / (2 * radius));
}

Outline Outline::scaled(double factor) const {
  std::vector<OutlineEdge> edges = edges_;
  for (OutlineEdge& edge : edges) edge = {factor * edge.x, factor * edge.y, factor * edge.bulge};
  return Outline(std::move(edges));
}

std::string Outline::piece(const std::string& name, const std::string& further) const {
  std::string text =
      fmt::format("  piece {} {{\n    outline from ({}, {}) {{\n", name, cm(edges_[0].x), cm(edges_[0].y));
  for (int i = 0; i < count(); ++i) {
    const OutlineEdge& from = edges_[static_cast<std::size_t>(i)];
    const OutlineEdge& to = edges_[static_cast<std::size_t>((i + 1) % count())];
    const std::string end = i + 1 == count() ? "start" : fmt::format("({}, {})", cm(to.x), cm(to.y));
    if (from.bulge == 0) {
      text += fmt::format("      e{} = line to {}\n", i, end);
      continue;
    }
    // Outlines go round counter-clockwise: an arc that turns left bulges outwards.
    const double chord = this->chord(i), bulge = from.bulge;
    const double radius = (chord * chord / 4 + bulge * bulge) / (2 * bulge);
    text += fmt::format("      e{} = arc to {} radius {}\n", i, end, cm(radius));
  }
  return text + "    }\n" + further + "  }\n";
}

std::string Outline::random_dart(Dice& dice) const {
  if (dice.chance(0.5)) return "";
  for (int i = 0; i < count(); ++i) {
    if (edges_[static_cast<std::size_t>(i)].bulge != 0 || chord(i) < 0.5 * chord((i + 1) % count())) continue;
    return fmt::format("    dart at {:.3g}% of e{} {{ width {}, depth {} }}\n", dice.uniform(40, 60), i,
                       cm(chord(i) * dice.uniform(0.03, 0.2)), cm(chord(i) * dice.uniform(0.15, 0.35)));
  }
  return "";
}

Outline random_outline(Dice& dice, double size) {
  const int corners = dice.from(3, 9);
  const bool curved = corners > 3 && dice.chance(0.6);
  std::vector<OutlineEdge> edges;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * (i + dice.uniform(-0.25, 0.25)) / corners;
    const double radius = size * dice.uniform(0.65, 1);
    edges.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  if (curved) {
    const std::vector<OutlineEdge> straight = edges;
    const Outline chords(straight);
    for (int i = 0; i < corners; ++i) {
      const double bulge = dice.uniform(-0.08, 0.12);
      if (std::abs(bulge) > 0.02) edges[static_cast<std::size_t>(i)].bulge = bulge * chords.length(i);
    }
  }
  return Outline(std::move(edges));
}

}  // namespace toile::test
