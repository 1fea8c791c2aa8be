// Functions that the language brings along. Each states its parameters as data, so that their kinds are checked in one
// place; what it computes sees arguments that fit.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/evaluate/call.hpp"

namespace toile {

enum class Want {
  Plain,
  Length,
  Angle,
  AnyQuantity,
  Softness,
  Point,
  Curve,
  PointOrCurve,
  List,
  Text,
  Truth,
  Body,  // or a line of it, whose axis is meant
  BodyLine,
  Map,        // of a body; for a body or a line of it the one that pieces drawn on it have
  Space,      // a point in space
  Direction,  // three plain numbers
  Along,      // a length or a fraction
  Place       // the same, or a point of the curve, or a curve across it
};

struct BuiltinParameter {
  std::string_view name;
  Want want;
  bool optional = false;
};

/// A call whose arguments have the kinds that were wanted. Magnitudes may be missing: see `known`.
struct BuiltinCall {
  Session& session;
  Location at;
  const std::vector<std::optional<Given>>& given;
  bool known = true;  // all magnitudes are there

  bool has(std::size_t i) const { return i < given.size() && given[i].has_value(); }
  const Value& value(std::size_t i) const { return given[i]->value; }
  Location place(std::size_t i) const { return given[i]->at; }
  const Quantity& quantity(std::size_t i) const { return *value(i).as<Quantity>(); }
  double si(std::size_t i) const { return quantity(i).si; }
  double si_or(std::size_t i, double fallback) const { return has(i) ? si(i) : fallback; }
  Vec2 point(std::size_t i) const { return value(i).as<Point>()->at; }
  const Curve& curve(std::size_t i) const { return *value(i).as<PlaneCurve>()->curve; }
  /// Reports a value that the function cannot take, and gives Unknown.
  Value refuse(std::string code, std::string message, std::size_t argument) const;
};

struct Builtin {
  std::string_view name;
  std::vector<BuiltinParameter> parameters;
  Value (*apply)(const BuiltinCall&) = nullptr;
  bool variadic = false;               // the last parameter takes any number of arguments
  std::optional<Value> constant = {};  // `pi`: no function at all
};

const Builtin* find_builtin(std::string_view name);
std::vector<std::string> builtin_names();

Value call_builtin(Session& session, const Scope& scope, const syntax::Call& written, const Builtin& builtin);

// The tables, by topic.
std::vector<Builtin> number_builtins();
std::vector<Builtin> geometry_builtins();
std::vector<Builtin> drafting_builtins();
std::vector<Builtin> body_builtins();
std::vector<Builtin> chart_builtins();

}  // namespace toile
