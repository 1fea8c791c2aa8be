// Maps of a body's surface to the plane.
#include <fmt/format.h>

#include <cmath>

#include "compiler/evaluate/builtins.hpp"
#include "compiler/pattern/chart_spec.hpp"
#include "compiler/units/format.hpp"

namespace toile {
namespace {

/// The body, and what both maps have: its scale and the ease between body and cloth.
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

}  // namespace

std::vector<Builtin> chart_builtins() {
  using enum Want;
  return {
      {"cylinder_map", {{"body", Body}, {"radius", Length, true}, {"ease", Length, true}}, cylinder_map},
      {"dome_map",
       {{"body", Body},
        {"towards", Direction, true},
        {"centre", Space, true},
        {"radius", Length, true},
        {"ease", Length, true}},
       dome_map},
  };
}

}  // namespace toile
