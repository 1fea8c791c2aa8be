// What drafting does with curves: where they meet, what stands square on them or touches them, and curves from curves.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/curve/places.hpp"
#include "compiler/curve/shape.hpp"
#include "compiler/evaluate/builtins.hpp"
#include "compiler/evaluate/curves.hpp"

namespace toile {
namespace {

Value point_of(Vec2 at) {
  return Point{dimension::length, at};
}
Value some_point() {
  return {Point{dimension::length, {}}, false};
}
Value some_points() {
  return list_value({some_point()}, false);
}
Value some_curve() {
  return {PlaneCurve{}, false};
}
Value curve_or_nothing(std::optional<Curve> curve) {
  return curve ? curve_value(std::move(*curve)) : Value{};
}

Value points_at(const Curve& curve, const std::vector<double>& places) {
  std::vector<Value> points;
  for (const double s : places) points.push_back(point_of(curve.at(s)));
  return list_value(std::move(points));
}

// ------------------------------------------------------------------------------------------------ places

Value all_intersections(const BuiltinCall& call) {
  if (!call.known) return some_points();
  std::vector<Value> points;
  for (const Crossing& c : intersections(call.curve(0), call.curve(1))) points.push_back(point_of(c.point));
  return list_value(std::move(points));
}

Value intersection(const BuiltinCall& call) {
  if (!call.known) return some_point();
  const auto found = only_crossing(call.session, call.curve(0), call.curve(1), call.place(1));
  return found ? point_of(found->point) : Value{};
}

Value all_feet(const BuiltinCall& call) {
  if (!call.known) return some_points();
  return points_at(call.curve(1), perpendicular_feet(call.curve(1), call.point(0)));
}

Value foot(const BuiltinCall& call) {
  if (!call.known) return some_point();
  const Curve& curve = call.curve(1);
  const std::vector<double> feet = perpendicular_feet(curve, call.point(0));
  const auto far = [&](double s) { return distance(curve.at(s), call.point(0)); };
  const auto nearest_foot =
      std::min_element(feet.begin(), feet.end(), [&](double a, double b) { return far(a) < far(b); });
  if (nearest_foot != feet.end()) return point_of(curve.at(*nearest_foot));
  call.session.report.add(Problem("E0217", "no perpendicular from this point falls on the curve")
                              .at(call.place(0))
                              .also(call.place(1), "the curve")
                              .help("prolong the curve, extend(line, after: 10cm), or take nearest(point, curve)"));
  return Unknown{};
}

Value nearest(const BuiltinCall& call) {
  if (!call.known) return some_point();
  return point_of(call.curve(1).at(nearest_place(call.curve(1), call.point(0))));
}

Value all_tangents(const BuiltinCall& call) {
  if (!call.known) return some_points();
  return points_at(call.curve(1), tangent_places(call.curve(1), call.point(0)));
}

Value length_to(const BuiltinCall& call) {
  if (!call.known) return metres(0, false);
  const auto s = arc_length_at(call.session, call.curve(0), call.value(1), call.place(1), "the curve's end");
  return s ? metres(*s) : Value{};
}

Value curvature_on(const BuiltinCall& call) {
  if (!call.known) return {Quantity{dimension::curvature}, false};
  const auto s = arc_length_at(call.session, call.curve(0), call.value(1), call.place(1), "the curve's end");
  return s ? Value{Quantity{dimension::curvature, call.curve(0).curvature(*s)}} : Value{};
}

/// Halfway, or a fraction or a length of the way.
Value between(const BuiltinCall& call) {
  if (!call.known) return some_point();
  const Vec2 from = call.point(0), way = call.point(1) - from;
  if (!call.has(2)) return point_of(from + 0.5 * way);
  if (call.quantity(2).dimension.plain()) return point_of(from + call.si(2) * way);
  if (norm(way) == 0) return call.refuse("E0206", "from a point to itself there is no direction", 1);
  return point_of(from + call.si(2) / norm(way) * way);
}

// ------------------------------------------------------------------------------------------------ curves

Value round_about(const BuiltinCall& call) {
  if (!call.known) return some_curve();
  if (call.si(1) <= 0) return call.refuse("E0208", "a radius must be positive", 1);
  const double from = call.si_or(2, 0);
  return curve_value(arc_about(call.point(0), call.si(1), from, from + 2 * std::numbers::pi));
}

Value part_of_a_circle(const BuiltinCall& call) {
  if (!call.known) return some_curve();
  if (call.si(1) <= 0) return call.refuse("E0208", "a radius must be positive", 1);
  if (call.si(2) == call.si(3)) return call.refuse("E0209", "an arc from an angle to the same one has no length", 3);
  if (std::abs(call.si(3) - call.si(2)) > 2 * std::numbers::pi * (1 + 1e-12)) {
    return call.refuse("E0209", "this arc would run more than once round its circle", 3);
  }
  return curve_value(arc_about(call.point(0), call.si(1), call.si(2), call.si(3)));
}

/// Out along a radius, round, and back.
Value sector(const BuiltinCall& call) {
  Value round = part_of_a_circle(call);
  const auto* arc = round.as<PlaneCurve>();
  if (arc == nullptr || !round.known()) return round;
  const Vec2 centre = call.point(0);
  return curve_value(join({line(centre, arc->curve->start()), *arc->curve, line(arc->curve->end(), centre)}));
}

Value through_points(const BuiltinCall& call) {
  std::vector<Vec2> points;
  for (const Value& item : *call.value(0).as<ListValue>()->items) {
    if (item.unknown()) return Unknown{};
    const auto* point = item.as<Point>();
    if (point == nullptr || point->dimension != dimension::length) {
      return call.refuse("E0203", "`spline` takes a list of points, and this is one of " + describe(item), 0);
    }
    points.push_back(point->at);
  }
  if (!call.known) return some_curve();
  const auto angle = [&](std::size_t i) { return call.has(i) ? std::optional(call.si(i)) : std::nullopt; };
  const bool closed = call.has(3) && call.value(3).as<Truth>()->value;
  if (closed && (call.has(1) || call.has(2))) {
    return call.refuse("E0209", "a closed curve has no ends that it could leave or arrive at", call.has(1) ? 1 : 2);
  }
  return curve_or_nothing(drawn_spline(call.session, points, angle(1), angle(2), closed, call.place(0)));
}

Value prolonged(const BuiltinCall& call) {
  if (!call.known) return some_curve();
  for (const std::size_t i : {1, 2}) {
    if (call.si_or(i, 0) < 0) return call.refuse("E0208", "a curve is prolonged by a positive length", i);
  }
  return curve_value(extended(call.curve(0), call.si_or(1, 0), call.si_or(2, 0)));
}

Value beside(const BuiltinCall& call) {
  if (!call.known) return some_curve();
  if (auto found = offset(call.curve(0), call.si(1))) return curve_value(std::move(*found));
  call.session.report.add(Problem("E0215", "nothing is left of this curve, or no one piece, so far aside")
                              .at(call.place(1), "this is " + format(call.value(1)))
                              .help("the inside of a bend folds where the distance exceeds its radius"));
  return Unknown{};
}

Value with_length(const BuiltinCall& call) {
  if (!call.known) return some_curve();
  return curve_or_nothing(lengthened(call.session, call.curve(0), call.si(1), call.place(1)));
}

/// Two curves with the corner between them rounded.
Value rounded_corner(const BuiltinCall& call) {
  if (!call.known) return list_value({some_curve(), some_curve(), some_curve()}, false);
  constexpr double same = 1e-6;  // [m]
  if (call.si(2) <= 0) return call.refuse("E0208", "a radius must be positive", 2);
  if (distance(call.curve(0).end(), call.curve(1).start()) > same) {
    return call.refuse("E0211", "the second curve does not begin where the first one ends", 1);
  }
  if (const auto parts = fillet(call.curve(0), call.curve(1), call.si(2))) {
    return list_value({curve_value((*parts)[0]), curve_value((*parts)[1]), curve_value((*parts)[2])});
  }
  return call.refuse("E0209", "no arc of this radius touches both curves beside their corner", 2);
}

Value split(const BuiltinCall& call) {
  if (!call.known) return list_value({some_curve()}, false);
  const Curve& curve = call.curve(0);
  std::vector<Value> parts;
  double before = 0;
  for (std::size_t i = 1; i < call.given.size(); ++i) {
    const auto s = arc_length_at(call.session, curve, call.value(i), call.place(i), "the curve's end");
    if (!s) return Unknown{};
    if (*s <= before || *s >= curve.length()) {
      return call.refuse("E0209", "a curve is split between its ends, at one place behind the other", i);
    }
    parts.push_back(curve_value(curve.part(before, *s)));
    before = *s;
  }
  parts.push_back(curve_value(curve.part(before, curve.length())));
  return list_value(std::move(parts));
}

}  // namespace

std::vector<Builtin> drafting_builtins() {
  using enum Want;
  const BuiltinParameter along{"curve", Want::Curve};
  const BuiltinParameter from_point{"point", Want::Point};
  const std::vector<BuiltinParameter> two_curves{{"first", Want::Curve}, {"second", Want::Curve}};
  const std::vector<BuiltinParameter> of_a_circle{
      {"about", Want::Point}, {"radius", Length}, {"from", Angle}, {"to", Angle}};
  return {
      {"intersections", two_curves, all_intersections},
      {"intersection", two_curves, intersection},
      {"feet", {from_point, along}, all_feet},
      {"foot", {from_point, along}, foot},
      {"nearest", {from_point, along}, nearest},
      {"tangents", {from_point, along}, all_tangents},
      {"length_to", {along, {"at", Place}}, length_to},
      {"curvature_on", {along, {"at", Place}}, curvature_on},
      {"between", {{"from", Want::Point}, {"to", Want::Point}, {"at", Along, true}}, between},
      {"circle", {{"about", Want::Point}, {"radius", Length}, {"from", Angle, true}}, round_about},
      {"arc_about", of_a_circle, part_of_a_circle},
      {"sector", of_a_circle, sector},
      {"spline",
       {{"points", List}, {"leaving", Angle, true}, {"arriving", Angle, true}, {"closed", Want::Truth, true}},
       through_points},
      {"extend", {along, {"before", Length, true}, {"after", Length, true}}, prolonged},
      {"offset", {along, {"by", Length}}, beside},
      {"with_length", {along, {"length", Length}}, with_length},
      {"fillet", {{"first", Want::Curve}, {"second", Want::Curve}, {"radius", Length}}, rounded_corner},
      {"split", {along, {"at", Place}}, split, true},
  };
}

}  // namespace toile
