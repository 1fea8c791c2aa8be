#include "compiler/evaluate/curves.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/curve/places.hpp"
#include "compiler/curve/shape.hpp"
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

namespace {

std::string shown_points(const std::vector<Crossing>& crossings) {
  std::string text;
  for (const Crossing& c : crossings) text += (text.empty() ? "" : ", ") + format(Point{dimension::length, c.point});
  return text;
}

}  // namespace

std::optional<Crossing> only_crossing(Session& session, const Curve& first, const Curve& second, Location at) {
  const std::vector<Crossing> found = intersections(first, second);
  if (found.size() == 1) return found.front();
  if (found.empty()) {
    session.report.add(Problem("E0211", "these curves do not meet")
                           .at(at, "runs from " + format(Point{dimension::length, second.start()}) + " to " +
                                       format(Point{dimension::length, second.end()}))
                           .help("prolong the one that is too short: extend(line, after: 10cm)"));
  } else {
    session.report.add(
        Problem("E0212", fmt::format("these curves meet {} times: at {}", found.size(), shown_points(found)))
            .at(at)
            .help("say which is meant: intersections(a, b)[1] is the first along a"));
  }
  return std::nullopt;
}

namespace {

std::optional<double> place_of_point(Session& session, const Curve& curve, Vec2 point, Location at) {
  constexpr double touching = 1e-6;  // [m]
  const double s = nearest_place(curve, point);
  const double off = distance(curve.at(s), point);
  if (off <= touching) return s;
  session.report.add(
      Problem("E0213", fmt::format("this point lies {} off the curve", format_quantity(off, dimension::length)))
          .at(at, "is " + format(Point{dimension::length, point}))
          .help("nearest(point, curve) is the place of the curve that is nearest to it, " +
                format(Point{dimension::length, curve.at(s)})));
  return std::nullopt;
}

}  // namespace

std::optional<double> arc_length_at(Session& session, const Curve& curve, const Value& where, Location at,
                                    const std::string& whose) {
  if (!where.known()) return std::nullopt;
  if (const auto* point = where.as<Point>()) return place_of_point(session, curve, point->at, at);
  if (const auto* other = where.as<PlaneCurve>()) {
    const auto crossing = only_crossing(session, curve, *other->curve, at);
    return crossing ? std::optional(crossing->s_first) : std::nullopt;
  }
  const auto* quantity = where.as<Quantity>();
  if (quantity == nullptr) return std::nullopt;
  const bool fraction = quantity->dimension.plain();
  const double whole = curve.length();
  const double s = fraction ? quantity->si * whole : quantity->si;
  constexpr double slack = 1e-9;  // [m] rounding of a length that was computed from the curve's own
  if (s >= -slack && s <= whole + slack) return std::min(std::max(s, 0.0), whole);
  const std::string wanted = fraction ? format_quantity(quantity->si, {}, true) : format(where);
  session.report.add(Problem("E0209", s < 0 ? fmt::format("{} is negative: places count from the beginning", wanted)
                                            : fmt::format("{} is beyond {}", wanted, whose))
                         .at(at)
                         .help(fraction
                                   ? "a fraction lies between 0 % and 100 %, a length has its unit: `55%` or `18cm`"
                                   : "it is " + format_quantity(whole, dimension::length) + " long"));
  return std::nullopt;
}

std::optional<Curve> drawn_spline(Session& session, const std::vector<Vec2>& points, std::optional<double> leaving,
                                  std::optional<double> arriving, bool closed, Location at) {
  const std::size_t least = closed ? 3 : 2;
  if (points.size() < least) {
    session.report.add(Problem("E0214", fmt::format("{} passes through {} points or more, here {}",
                                                    closed ? "a closed curve" : "a curve", least, points.size()))
                           .at(at));
    return std::nullopt;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i + 1 == points.size() && !closed) break;
    const Vec2 next = points[(i + 1) % points.size()];
    if (distance(points[i], next) >= nearly_nothing) continue;
    session.report.add(Problem("E0214", fmt::format("two points in turn are the same, {}: no curve runs between them",
                                                    format(Point{dimension::length, next})))
                           .at(at));
    return std::nullopt;
  }
  return closed ? closed_spline(points) : spline(points, leaving, arriving);
}

std::optional<Curve> lengthened(Session& session, const Curve& curve, double length, Location at) {
  if (auto found = of_length(curve, length)) return found;
  const std::string wanted = format_quantity(length, dimension::length);
  const double apart = distance(curve.start(), curve.end());
  Problem problem("E0216", fmt::format("this curve cannot be {} long", wanted));
  problem.at(at);
  if (length <= apart) {
    problem.help(fmt::format("its ends are {} apart", format_quantity(apart, dimension::length)));
  } else if (curve.segments().size() == 1 && std::holds_alternative<LineSegment>(curve.segments()[0])) {
    problem.help("a straight line between two points has one length: bend it, `curve to P leaving 10deg long ...`");
  } else {
    problem.help(fmt::format("it is {} long as drawn; to be so much longer or shorter it would have to cross itself",
                             format_quantity(curve.length(), dimension::length)));
  }
  session.report.add(problem);
  return std::nullopt;
}

}  // namespace toile
