#include "compiler/evaluate/curves.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/units/format.hpp"

namespace toile {
namespace {

constexpr double nearly_nothing = 1e-9;  // [m] far below what can be drawn

}  // namespace

Curve drawn_curve(Vec2 from, Vec2 to, std::optional<double> leaving, std::optional<double> arriving) {
  const Vec2 chord = to - from;
  if ((!leaving && !arriving) || norm(chord) < nearly_nothing) return line(from, to);
  // A circular arc leaves and arrives at equal and opposite angles to its chord.
  const double along = std::atan2(chord.y, chord.x);
  return tangent_curve(from, leaving.value_or(2 * along - arriving.value_or(0)), to,
                       arriving.value_or(2 * along - leaving.value_or(0)));
}

std::optional<Curve> drawn_arc(Session& session, Vec2 from, Vec2 to, Vec2 through, Location at) {
  const double chord = distance(from, to);
  const double off_chord = std::abs(cross(to - from, through - from));
  const bool at_an_end = distance(from, through) < nearly_nothing || distance(to, through) < nearly_nothing;
  if (chord >= nearly_nothing && !at_an_end && off_chord > 1e-6 * chord * distance(from, through)) {
    return arc_through(from, through, to);
  }
  session.report.add(Problem("E0209", "no arc passes through three points on a line")
                         .at(at, "this point lies in line with the arc's ends")
                         .help("draw a line, or move the point aside"));
  return std::nullopt;
}

std::optional<Curve> drawn_arc(Session& session, Vec2 from, Vec2 to, double radius, bool large, Location at) {
  const double chord = distance(from, to);
  if (std::abs(radius) >= chord / 2 * (1 - 1e-12) && chord >= nearly_nothing) {
    const double least = std::copysign(std::max(std::abs(radius), chord / 2), radius);
    return arc_of_radius(from, to, least, large);
  }
  session.report.add(Problem("E0209", fmt::format("a radius of {} does not span the {} between the arc's ends",
                                                  format_quantity(std::abs(radius), dimension::length),
                                                  format_quantity(chord, dimension::length)))
                         .at(at)
                         .help("it must be at least " + format_quantity(chord / 2, dimension::length)));
  return std::nullopt;
}

std::optional<double> arc_length_at(Session& session, const Curve& curve, const Value& where, Location at,
                                    const std::string& whose) {
  const auto* quantity = where.as<Quantity>();
  if (quantity == nullptr || !where.known()) return std::nullopt;
  const bool fraction = quantity->dimension.plain();
  const double whole = curve.length();
  const double s = fraction ? quantity->si * whole : quantity->si;
  constexpr double slack = 1e-9;  // [m] rounding of a length that was computed from the curve's own
  if (s >= -slack && s <= whole + slack) return std::min(std::max(s, 0.0), whole);
  const std::string wanted = fraction ? format_quantity(quantity->si, {}, true) : format(where);
  session.report.add(Problem("E0209", fmt::format("{} is beyond {}", wanted, whose))
                         .at(at)
                         .help(fraction ? "a fraction lies between 0 % and 100 %"
                                        : "it is " + format_quantity(whole, dimension::length) + " long"));
  return std::nullopt;
}

}  // namespace toile
