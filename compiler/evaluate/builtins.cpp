#include "compiler/evaluate/builtins.hpp"

#include <map>

#include "compiler/evaluate/arithmetic.hpp"

namespace toile {
namespace {

const std::map<std::string_view, Builtin>& registry() {
  static const std::map<std::string_view, Builtin> all = [] {
    std::map<std::string_view, Builtin> by_name;
    for (auto table :
         {number_builtins(), geometry_builtins(), drafting_builtins(), body_builtins(), chart_builtins()}) {
      for (Builtin& builtin : table) by_name.emplace(builtin.name, std::move(builtin));
    }
    return by_name;
  }();
  return all;
}

bool fits(const Value& value, Want want) {
  const auto* quantity = value.as<Quantity>();
  const auto* point = value.as<Point>();
  const auto* space = value.as<Point3>();
  const bool is_point = point != nullptr && point->dimension == dimension::length;
  switch (want) {
    case Want::Plain:
      return quantity != nullptr && quantity->dimension.plain();
    case Want::Length:
      return quantity != nullptr && quantity->dimension == dimension::length;
    case Want::Angle:
      return quantity != nullptr && quantity->dimension == dimension::angle;
    case Want::Softness:
      return quantity != nullptr && quantity->dimension == dimension::softness;
    case Want::AnyQuantity:
      return quantity != nullptr;
    case Want::Along:
      return quantity != nullptr && (quantity->dimension.plain() || quantity->dimension == dimension::length);
    case Want::Place:
      return is_point || value.as<PlaneCurve>() != nullptr || fits(value, Want::Along);
    case Want::Point:
      return is_point;
    case Want::Curve:
      return value.as<PlaneCurve>() != nullptr;
    case Want::PointOrCurve:
      return is_point || value.as<PlaneCurve>() != nullptr;
    case Want::List:
      return value.as<ListValue>() != nullptr;
    case Want::Text:
      return value.as<Text>() != nullptr;
    case Want::Truth:
      return value.as<Truth>() != nullptr;
    case Want::Body:
      return value.as<BodyValue>() != nullptr || value.as<BodyLineValue>() != nullptr;
    case Want::BodyLine:
      return value.as<BodyLineValue>() != nullptr;
    case Want::Map:
      return value.as<ChartValue>() != nullptr || fits(value, Want::Body);
    case Want::Space:
      return space != nullptr && space->dimension == dimension::length;
    case Want::Direction:
      return space != nullptr && space->dimension.plain();
  }
  return false;
}

std::string_view words(Want want) {
  switch (want) {
    case Want::Plain:
      return "a plain number";
    case Want::Length:
      return "a length";
    case Want::Angle:
      return "an angle";
    case Want::Softness:
      return "a pressure per depth";
    case Want::AnyQuantity:
      return "a number or quantity";
    case Want::Along:
      return "a length or a fraction";
    case Want::Place:
      return "a length, a fraction, a point or a curve";
    case Want::Point:
      return "a point";
    case Want::Curve:
      return "a curve";
    case Want::PointOrCurve:
      return "a point or a curve";
    case Want::List:
      return "a list";
    case Want::Text:
      return "a text";
    case Want::Truth:
      return "true or false";
    case Want::Body:
      return "a body or a line of one";
    case Want::BodyLine:
      return "a line of a body";
    case Want::Map:
      return "a map of a body";
    case Want::Space:
      return "a point in space";
    case Want::Direction:
      return "a direction in space, (0, 0, 1)";
  }
  return "";
}

std::string help_for(const Value& value, Want want) {
  const auto* quantity = value.as<Quantity>();
  if (quantity == nullptr || !quantity->dimension.plain()) return "";
  if (want == Want::Angle) return "every angle has its unit: `12deg` or `0.2rad`";
  if (want == Want::Length) return "every length has its unit: `2cm`, not `2`";
  return "";
}

}  // namespace

Value BuiltinCall::refuse(std::string code, std::string message, std::size_t argument) const {
  session.report.add(Problem(std::move(code), std::move(message)).at(place(argument)));
  return Unknown{};
}

const Builtin* find_builtin(std::string_view name) {
  const auto found = registry().find(name);
  return found == registry().end() ? nullptr : &found->second;
}

std::vector<std::string> builtin_names() {
  std::vector<std::string> names;
  for (const auto& [name, builtin] : registry()) names.emplace_back(name);
  return names;
}

Value call_builtin(Session& session, const Scope& scope, const syntax::Call& written, const Builtin& builtin) {
  std::vector<Formal> formals;
  for (const BuiltinParameter& parameter : builtin.parameters) {
    const bool curve = parameter.want == Want::Curve || parameter.want == Want::PointOrCurve;
    formals.push_back({std::string(parameter.name), parameter.optional, curve});
  }
  const std::string callee = "`" + std::string(builtin.name) + "`";
  const auto given = bind_arguments(session, scope, written, callee, formals, builtin.variadic);
  if (!given) return Unknown{};
  bool sound = true;
  bool known = true;
  for (std::size_t i = 0; i < given->size(); ++i) {
    if (!(*given)[i]) continue;
    const Value& value = (*given)[i]->value;
    known = known && value.known();
    if (value.unknown()) sound = false;
    const BuiltinParameter& parameter = builtin.parameters[std::min(i, builtin.parameters.size() - 1)];
    if (value.unknown() || fits(value, parameter.want)) continue;
    sound = false;
    session.report.add(Problem("E0203", callee + " takes " + std::string(words(parameter.want)) + " as `" +
                                            std::string(parameter.name) + "`, and this is " + describe(value))
                           .at((*given)[i]->at, describe(value))
                           .help(help_for(value, parameter.want)));
  }
  if (!sound) return Unknown{};
  const Location at = scope.module().at(written);
  const Value result = builtin.apply({session, at, *given, known && session.supposing == 0});
  return checked(session, session.supposing > 0 ? forget(result) : result, at);
}

}  // namespace toile
