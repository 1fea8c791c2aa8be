// Functions of numbers and quantities, and of lists of them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/evaluate/builtins.hpp"

namespace toile {
namespace {

Value angle_value(double radians, bool known) {
  return {Quantity{dimension::angle, radians}, known};
}

Value square_root(const BuiltinCall& call) {
  const Quantity& x = call.quantity(0);
  const std::optional<Dimension> dim = root(x.dimension);
  if (!dim) return call.refuse("E0205", "there is no square root of " + describe(x.dimension), 0);
  if (call.known && x.si < 0) return call.refuse("E0206", "the square root of a negative number", 0);
  return {Quantity{*dim, call.known ? std::sqrt(x.si) : 0}, call.known};
}

template <double (*F)(double)>
Value of_angle(const BuiltinCall& call) {
  return number(F(call.si(0)), call.known);
}

Value arc_sine(const BuiltinCall& call) {
  if (call.known && std::abs(call.si(0)) > 1) return call.refuse("E0206", "no angle has a sine beyond 1", 0);
  return angle_value(std::asin(call.si(0)), call.known);
}

Value arc_cosine(const BuiltinCall& call) {
  if (call.known && std::abs(call.si(0)) > 1) return call.refuse("E0206", "no angle has a cosine beyond 1", 0);
  return angle_value(std::acos(call.si(0)), call.known);
}

Value arc_tangent(const BuiltinCall& call) {
  return angle_value(std::atan(call.si(0)), call.known);
}

Value arc_tangent_of_two(const BuiltinCall& call) {
  if (call.quantity(0).dimension != call.quantity(1).dimension) {
    return call.refuse("E0201", "`atan2` takes two quantities of one dimension", 1);
  }
  return angle_value(std::atan2(call.si(0), call.si(1)), call.known);
}

Value magnitude(const BuiltinCall& call) {
  const Quantity& x = call.quantity(0);
  return {Quantity{x.dimension, std::abs(x.si), x.percent}, call.known};
}

template <bool Largest>
Value extreme(const BuiltinCall& call) {
  Quantity best = call.quantity(0);
  for (std::size_t i = 1; i < call.given.size(); ++i) {
    const Quantity& next = call.quantity(i);
    if (next.dimension != best.dimension) {
      call.session.report.add(
          Problem("E0201", describe(best.dimension) + " and " + describe(next.dimension) + " cannot be compared")
              .at(call.place(0), describe(best.dimension))
              .at(call.place(i), describe(next.dimension)));
      return Unknown{};
    }
    if (Largest ? next.si > best.si : next.si < best.si) best = next;
  }
  return {best, call.known};
}

template <double (*F)(double)>
Value rounded(const BuiltinCall& call) {
  const Quantity& x = call.quantity(0);
  if (!call.has(1)) {
    if (!x.dimension.plain()) return call.refuse("E0203", "say to what it is rounded: `round(x, to: 1mm)`", 0);
    return number(F(x.si), call.known);
  }
  const Quantity& step = call.quantity(1);
  if (step.dimension != x.dimension) {
    return call.refuse("E0201", describe(x.dimension) + " cannot be rounded to " + describe(step.dimension), 1);
  }
  if (!call.known) return {Quantity{x.dimension, 0, x.percent}, false};
  if (step.si <= 0) return call.refuse("E0208", "the step of rounding must be positive", 1);
  return Quantity{x.dimension, F(x.si / step.si) * step.si, x.percent};
}

Value count(const BuiltinCall& call) {
  return number(static_cast<double>(call.value(0).as<ListValue>()->items->size()), call.known);
}

Value total(const BuiltinCall& call) {
  const std::vector<Value>& items = *call.value(0).as<ListValue>()->items;
  if (items.empty()) return call.known ? number(0) : Value{};
  const auto* first = items.front().as<Quantity>();
  if (first == nullptr) {
    if (items.front().unknown()) return Unknown{};
    return call.refuse("E0203", "`sum` takes a list of numbers or quantities", 0);
  }
  Quantity all{first->dimension, 0, first->percent};
  for (const Value& item : items) {
    const auto* quantity = item.as<Quantity>();
    if (quantity == nullptr) return Unknown{};
    all.si += quantity->si;
  }
  return {all, call.known};
}

}  // namespace

std::vector<Builtin> number_builtins() {
  const BuiltinParameter to{"to", Want::AnyQuantity, true};
  return {
      {"pi", {}, nullptr, false, number(std::numbers::pi)},
      {"sqrt", {{"x", Want::AnyQuantity}}, square_root},
      {"sin", {{"angle", Want::Angle}}, of_angle<std::sin>},
      {"cos", {{"angle", Want::Angle}}, of_angle<std::cos>},
      {"tan", {{"angle", Want::Angle}}, of_angle<std::tan>},
      {"asin", {{"x", Want::Plain}}, arc_sine},
      {"acos", {{"x", Want::Plain}}, arc_cosine},
      {"atan", {{"x", Want::Plain}}, arc_tangent},
      {"atan2", {{"y", Want::AnyQuantity}, {"x", Want::AnyQuantity}}, arc_tangent_of_two},
      {"abs", {{"x", Want::AnyQuantity}}, magnitude},
      {"min", {{"x", Want::AnyQuantity}}, extreme<false>, true},
      {"max", {{"x", Want::AnyQuantity}}, extreme<true>, true},
      {"round", {{"x", Want::AnyQuantity}, to}, rounded<std::round>},
      {"floor", {{"x", Want::AnyQuantity}, to}, rounded<std::floor>},
      {"ceil", {{"x", Want::AnyQuantity}, to}, rounded<std::ceil>},
      {"count", {{"list", Want::List}}, count},
      {"sum", {{"list", Want::List}}, total},
  };
}

}  // namespace toile
