// Points and curves as values.
#include <cmath>

#include "compiler/evaluate/builtins.hpp"
#include "compiler/evaluate/curves.hpp"

namespace toile {
namespace {

Value point_value(Vec2 at, bool known) {
  return {Point{dimension::length, at}, known};
}

Value unknown_curve() {
  return {PlaneCurve{}, false};
}

Value maybe(std::optional<Curve> curve) {
  return curve ? curve_value(std::move(*curve)) : Value{};
}

Value length_of(const BuiltinCall& call) {
  return metres(call.known ? call.curve(0).length() : 0, call.known);
}

Value straight(const BuiltinCall& call) {
  return call.known ? curve_value(line(call.point(0), call.point(1))) : unknown_curve();
}

Value arc(const BuiltinCall& call) {
  if (call.has(2) == call.has(3)) {
    call.session.report.add(Problem("E0108", "an arc needs a point to pass `through` or a `radius`, one of them")
                                .at(call.at)
                                .help("arc(p, q, radius: 12cm)"));
    return Unknown{};
  }
  if (!call.known) return unknown_curve();
  if (call.has(2)) return maybe(drawn_arc(call.session, call.point(0), call.point(1), call.point(2), call.place(2)));
  const bool large = call.has(4) && call.value(4).as<Truth>()->value;
  return maybe(drawn_arc(call.session, call.point(0), call.point(1), call.si(3), large, call.place(3)));
}

Value cubic(const BuiltinCall& call) {
  if (!call.known) return unknown_curve();
  return curve_value(bezier(call.point(0), call.point(1), call.point(2), call.point(3)));
}

Value tangent_controlled(const BuiltinCall& call) {
  if (!call.known) return unknown_curve();
  const auto angle = [&](std::size_t i) { return call.has(i) ? std::optional(call.si(i)) : std::nullopt; };
  return curve_value(drawn_curve(call.point(0), call.point(1), angle(2), angle(3)));
}

std::optional<double> place_on(const BuiltinCall& call, std::size_t argument) {
  return arc_length_at(call.session, call.curve(0), call.value(argument), call.place(argument), "the curve's end");
}

Value point_on(const BuiltinCall& call) {
  if (!call.known) return point_value({}, false);
  const auto s = place_on(call, 1);
  if (!s) return Unknown{};
  const Vec2 left = perpendicular(call.curve(0).tangent(*s));
  return point_value(call.curve(0).at(*s) + call.si_or(2, 0) * left, true);
}

Value direction_on(const BuiltinCall& call) {
  if (!call.known) return {Quantity{dimension::angle}, false};
  const auto s = place_on(call, 1);
  if (!s) return Unknown{};
  const Vec2 tangent = call.curve(0).tangent(*s);
  return Quantity{dimension::angle, std::atan2(tangent.y, tangent.x)};
}

Value part(const BuiltinCall& call) {
  if (!call.known) return unknown_curve();
  const auto from = call.has(1) ? place_on(call, 1) : std::optional(0.0);
  const auto to = call.has(2) ? place_on(call, 2) : std::optional(call.curve(0).length());
  if (!from || !to) return Unknown{};
  if (*from >= *to) return call.refuse("E0209", "a part of a curve begins before it ends", call.has(2) ? 2 : 1);
  return curve_value(call.curve(0).part(*from, *to));
}

Value reversed(const BuiltinCall& call) {
  return call.known ? curve_value(call.curve(0).reversed()) : unknown_curve();
}

Value joined(const BuiltinCall& call) {
  if (!call.known) return unknown_curve();
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < call.given.size(); ++i) {
    constexpr double touching = 1e-6;  // [m]
    if (i > 0 && distance(curves.back().end(), call.curve(i).start()) > touching) {
      return call.refuse("E0209", "this curve does not begin where the one before it ends", i);
    }
    curves.push_back(call.curve(i));
  }
  return curve_value(join(curves));
}

Value moved(const BuiltinCall& call) {
  const Vec2 shift = call.point(1);
  if (call.value(0).as<Point>() != nullptr) return point_value(call.point(0) + shift, call.known);
  return call.known ? curve_value(call.curve(0).moved(shift)) : unknown_curve();
}

Value mirrored(const BuiltinCall& call) {
  const bool is_point = call.value(0).as<Point>() != nullptr;
  if (!call.known) return is_point ? point_value({}, false) : unknown_curve();
  const Vec2 from = call.point(1);
  const Vec2 along = call.point(2) - from;
  if (norm(along) == 0) return call.refuse("E0209", "two different points make a line to mirror in", 2);
  const Vec2 axis = along / norm(along);
  if (!is_point) return curve_value(call.curve(0).mirrored(from, axis));
  const Vec2 offset = call.point(0) - from;
  return point_value(from + 2 * dot(offset, axis) * axis - offset, true);
}

Value rotated(const BuiltinCall& call) {
  const bool is_point = call.value(0).as<Point>() != nullptr;
  if (!call.known) return is_point ? point_value({}, false) : unknown_curve();
  const double angle = call.si(1);
  const Vec2 about = call.has(2) ? call.point(2) : Vec2{};
  if (!is_point) return curve_value(call.curve(0).rotated(angle, about));
  const Vec2 arm = call.point(0) - about;
  return point_value(about + std::cos(angle) * arm + std::sin(angle) * perpendicular(arm), true);
}

Value distance_between(const BuiltinCall& call) {
  return metres(distance(call.point(0), call.point(1)), call.known);
}

Value angle_from_to(const BuiltinCall& call) {
  const Vec2 way = call.point(1) - call.point(0);
  if (call.known && norm(way) == 0) return call.refuse("E0206", "from a point to itself there is no direction", 1);
  return {Quantity{dimension::angle, std::atan2(way.y, way.x)}, call.known};
}

Value polar(const BuiltinCall& call) {
  return point_value(call.si(0) * direction(call.si(1)), call.known);
}

}  // namespace

std::vector<Builtin> geometry_builtins() {
  using enum Want;
  const BuiltinParameter along{"curve", Want::Curve};
  return {
      {"length", {along}, length_of},
      {"line", {{"from", Want::Point}, {"to", Want::Point}}, straight},
      {"arc",
       {{"from", Want::Point},
        {"to", Want::Point},
        {"through", Want::Point, true},
        {"radius", Length, true},
        {"large", Want::Truth, true}},
       arc},
      {"bezier", {{"from", Want::Point}, {"first", Want::Point}, {"second", Want::Point}, {"to", Want::Point}}, cubic},
      {"curve",
       {{"from", Want::Point}, {"to", Want::Point}, {"leaving", Angle, true}, {"arriving", Angle, true}},
       tangent_controlled},
      {"point_on", {along, {"at", Want::Place}, {"across", Length, true}}, point_on},
      {"direction_on", {along, {"at", Want::Place}}, direction_on},
      {"part", {along, {"from", Want::Place, true}, {"to", Want::Place, true}}, part},
      {"reverse", {along}, reversed},
      {"join", {along}, joined, true},
      {"move", {{"what", PointOrCurve}, {"by", Want::Point}}, moved},
      {"mirror", {{"what", PointOrCurve}, {"from", Want::Point}, {"to", Want::Point}}, mirrored},
      {"rotate", {{"what", PointOrCurve}, {"by", Angle}, {"about", Want::Point, true}}, rotated},
      {"distance", {{"from", Want::Point}, {"to", Want::Point}}, distance_between},
      {"angle", {{"from", Want::Point}, {"to", Want::Point}}, angle_from_to},
      {"polar", {{"distance", Length}, {"angle", Angle}}, polar},
  };
}

}  // namespace toile
