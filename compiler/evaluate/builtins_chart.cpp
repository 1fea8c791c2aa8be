// Maps of a body's surface to the plane, and what they show of it.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compiler/evaluate/bodies.hpp"
#include "compiler/evaluate/builtins.hpp"
#include "compiler/evaluate/charts.hpp"
#include "compiler/evaluate/curves.hpp"
#include "compiler/pattern/chart_spec.hpp"
#include "compiler/units/format.hpp"

namespace toile {
namespace {

constexpr double flattest_cone = 0.1 * std::numbers::pi / 180, steepest_cone = 80 * std::numbers::pi / 180;
constexpr std::size_t no_argument = 99;

/// The body, and what maps have: a scale and the ease between body and cloth.
Value chart(const BuiltinCall& call, ChartSpec spec, std::size_t radius, std::size_t ease) {
  std::shared_ptr<BodyInstance> body;
  if (const auto* line = call.value(0).as<BodyLineValue>()) {
    body = line->body;
    spec.line = line->line;
  } else {
    body = call.value(0).as<BodyValue>()->body;
  }
  if (call.has(radius)) {
    spec.radius = call.si(radius);
    if (spec.radius <= 0) {
      return call.refuse(
          "E0208", fmt::format("the radius of a map must be positive, and this is {}", format(call.value(radius))),
          radius);
    }
  }
  if (call.has(ease)) {
    spec.ease = call.si(ease);
    if (spec.ease < 0) return call.refuse("E0208", "ease lies outside of the body: it cannot be negative", ease);
  }
  return ChartValue{std::move(body), std::make_shared<const ChartSpec>(std::move(spec))};
}

Value cylinder_map(const BuiltinCall& call) {
  return call.known ? chart(call, {}, 1, 2) : Value{};
}

Value cone_map(const BuiltinCall& call) {
  if (!call.known) return Unknown{};
  ChartSpec spec;
  spec.map = ChartSpec::Map::Cone;
  spec.angle = call.si(1);
  spec.radius = 0;
  if (std::abs(spec.angle) < flattest_cone || std::abs(spec.angle) > steepest_cone) {
    return call.refuse(
        "E0208",
        fmt::format("the side of a cone is off its axis by 0.1deg to 80deg, and this is {}", format(call.value(1))), 1);
  }
  return chart(call, spec, 2, 3);
}

Value dome_map(const BuiltinCall& call) {
  if (!call.known) return Unknown{};
  ChartSpec spec;
  spec.map = ChartSpec::Map::Dome;
  if (call.has(1)) spec.pole = call.value(1).as<Point3>()->at;
  if (spec.pole && !(std::hypot((*spec.pole)[0], (*spec.pole)[1], (*spec.pole)[2]) > 1e-9)) {
    return call.refuse("E0208", "(0, 0, 0) is no direction", 1);
  }
  if (call.has(2)) spec.centre = call.value(2).as<Point3>()->at;
  return chart(call, spec, 3, 4);
}

Value conformal_map(const BuiltinCall& call) {
  if (!call.known) return Unknown{};
  ChartSpec spec;
  spec.map = ChartSpec::Map::Conformal;
  const bool limb = call.value(0).as<BodyLineValue>() != nullptr;
  if (limb == call.has(1)) {
    call.session.report.add(
        Problem("E0108", "a conformal map shows the part of a body about a point, or what lies beyond a line")
            .at(call.at)
            .help("conformal_map(form, at: (9cm, -12cm, 120cm), reach: 12cm) or "
                  "conformal_map(form.left_armhole, reach: 7cm)"));
    return Unknown{};
  }
  if (call.has(1)) spec.centre = call.value(1).as<Point3>()->at;
  if (call.has(3) && !limb) return call.refuse("E0208", "only a limb is cut open: what lies beyond a line", 3);
  if (call.has(3)) spec.cut = call.si(3);
  spec.reach = call.si_or(2, spec.reach);
  if (spec.reach <= 0) return call.refuse("E0208", "a map's reach must be positive", 2);
  return chart(call, spec, no_argument, 4);
}

/// What the world says to a question about the map that is the first argument; nothing after an error.
std::optional<ChartAnswer> answered(const BuiltinCall& call, const ChartQuestion& question) {
  const ChartValue map = chart_meant(call.value(0));
  if (map.body == nullptr || body_lines(call.session, *map.body, call.at) == nullptr) return std::nullopt;
  auto found = call.session.world.charted(map.body->spec, *map.spec, question);
  if (const auto* trouble = std::get_if<std::string>(&found)) {
    call.session.report.add(Problem("E0512", *trouble).at(call.at, "in this map of `" + map.body->spec.name + "`"));
    return std::nullopt;
  }
  return std::get<ChartAnswer>(std::move(found));
}

Value curve_answered(const BuiltinCall& call, const ChartQuestion& question) {
  std::optional<ChartAnswer> found = answered(call, question);
  return found && !found->curve.empty() ? curve_value(std::move(found->curve)) : Value{};
}

Value place_in(const BuiltinCall& call) {
  if (!call.known) return {Point{dimension::length, {}}, false};
  ChartQuestion question;
  question.points = {call.value(1).as<Point3>()->at};
  const auto found = answered(call, question);
  return found ? Value{Point{dimension::length, found->place}} : Value{};
}

Value line_in(const BuiltinCall& call) {
  if (!call.known) return {PlaneCurve{}, false};
  const auto* line = call.value(1).as<BodyLineValue>();
  if (line->body != chart_meant(call.value(0)).body) {
    return call.refuse("E0510", fmt::format("this map is not of `{}`, which has the line", line->body->spec.name), 1);
  }
  ChartQuestion question;
  question.kind = ChartQuestion::Kind::Line;
  question.line = line->line;
  return curve_answered(call, question);
}

Value geodesic_in(const BuiltinCall& call) {
  if (!call.known) return {PlaneCurve{}, false};
  ChartQuestion question;
  question.kind = ChartQuestion::Kind::Geodesic;
  question.from = call.point(1);
  question.to = call.point(2);
  return curve_answered(call, question);
}

Value drawn_in(const BuiltinCall& call) {
  if (!call.known) return {PlaneCurve{}, false};
  ChartQuestion question;
  question.kind = ChartQuestion::Kind::Drawn;
  for (const Value& item : *call.value(1).as<ListValue>()->items) {
    const auto* point = item.as<Point3>();
    if (point == nullptr || point->dimension != dimension::length) {
      return call.refuse("E0203",
                         "a line on a body is drawn through points in space, and one of these is " + describe(item), 1);
    }
    question.points.push_back(point->at);
  }
  if (question.points.size() < 2) return call.refuse("E0208", "a line is drawn through two points or more", 1);
  return curve_answered(call, question);
}

}  // namespace

std::vector<Builtin> chart_builtins() {
  using enum Want;
  return {
      {"cylinder_map", {{"body", Body}, {"radius", Length, true}, {"ease", Length, true}}, cylinder_map},
      {"cone_map", {{"line", BodyLine}, {"angle", Angle}, {"radius", Length, true}, {"ease", Length, true}}, cone_map},
      {"dome_map",
       {{"body", Body},
        {"towards", Direction, true},
        {"centre", Space, true},
        {"radius", Length, true},
        {"ease", Length, true}},
       dome_map},
      {"conformal_map",
       {{"body", Body}, {"at", Space, true}, {"reach", Length, true}, {"cut", Angle, true}, {"ease", Length, true}},
       conformal_map},
      {"place_in", {{"map", Map}, {"point", Space}}, place_in},
      {"line_in", {{"map", Map}, {"line", BodyLine}}, line_in},
      {"geodesic_in", {{"map", Map}, {"from", Point}, {"to", Point}}, geodesic_in},
      {"drawn_in", {{"map", Map}, {"points", List}}, drawn_in},
  };
}

}  // namespace toile
