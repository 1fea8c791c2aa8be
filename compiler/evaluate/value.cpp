#include "compiler/evaluate/value.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/evaluate/instances.hpp"
#include "compiler/units/format.hpp"

namespace toile {
namespace {

template <typename... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <typename... F>
Overloaded(F...) -> Overloaded<F...>;

}  // namespace

Value number(double value, bool known) {
  return {Quantity{dimension::number, value}, known};
}

Value metres(double value, bool known) {
  return {Quantity{dimension::length, value}, known};
}

Value curve_value(Curve curve) {
  return PlaneCurve{std::make_shared<const Curve>(std::move(curve))};
}

Value list_value(std::vector<Value> items, bool known) {
  return {ListValue{std::make_shared<const std::vector<Value>>(std::move(items))}, known};
}

Value record_value(std::vector<RecordValue::Field> fields) {
  bool known = true;
  for (const RecordValue::Field& field : fields) known = known && field.value.known();
  return {RecordValue{std::make_shared<const std::vector<RecordValue::Field>>(std::move(fields))}, known};
}

Value forget(const Value& value) {
  return std::visit(Overloaded{
                        [](const Quantity& q) -> Value {
                          return {Quantity{q.dimension, 0, q.percent}, false};
                        },
                        [](const Truth&) -> Value {
                          return {Truth{}, false};
                        },
                        [](const Point& p) -> Value {
                          return {Point{p.dimension, {}}, false};
                        },
                        [](const Point3& p) -> Value {
                          return {Point3{p.dimension, {}}, false};
                        },
                        [](const PlaneCurve&) -> Value {
                          return {PlaneCurve{}, false};
                        },
                        [](const ListValue& list) -> Value {
                          if (list.items->empty()) return list_value({}, false);
                          return list_value({forget(list.items->front())}, false);
                        },
                        [](const RecordValue& record) -> Value {
                          std::vector<RecordValue::Field> fields = *record.fields;
                          for (RecordValue::Field& field : fields) field.value = forget(field.value);
                          return record_value(std::move(fields));
                        },
                        [&](const auto&) -> Value { return value; },
                    },
                    value.data());
}

std::string describe(const Value& value) {
  return std::visit(Overloaded{
                        [](const Unknown&) -> std::string { return "a value"; },
                        [](const Quantity& q) { return describe(q.dimension); },
                        [](const Truth&) -> std::string { return "a truth (true or false)"; },
                        [](const Text&) -> std::string { return "a text"; },
                        [](const Colour&) -> std::string { return "a colour"; },
                        [](const Point& p) -> std::string {
                          return p.dimension == dimension::length ? "a point" : "a pair of numbers";
                        },
                        [](const Point3&) -> std::string { return "a point in space"; },
                        [](const PlaneCurve&) -> std::string { return "a curve"; },
                        [](const ListValue&) -> std::string { return "a list"; },
                        [](const RecordValue& record) -> std::string {
                          std::string names;
                          for (const auto& field : *record.fields) names += (names.empty() ? "" : ", ") + field.name;
                          return "a record (" + names + ")";
                        },
                        [](const BodyValue&) -> std::string { return "a body"; },
                        [](const BodyLineValue&) -> std::string { return "a line of a body"; },
                        [](const ChartValue&) -> std::string { return "a map of a body"; },
                        [](const FabricValue&) -> std::string { return "a fabric"; },
                        [](const TextileValue&) -> std::string { return "a textile"; },
                        [](const ResultValue& result) -> std::string {
                          return result.drape->develops ? "a development" : "a drape's result";
                        },
                        [](FunctionRef) -> std::string { return "a function"; },
                        [](BuiltinRef) -> std::string { return "a function"; },
                        [](ModuleRef) -> std::string { return "a module"; },
                        [](BodyTemplateRef) -> std::string { return "a body with parameters"; },
                        [](GarmentTemplateRef) -> std::string { return "a garment with parameters"; },
                        [](PieceTemplateRef) -> std::string { return "a piece with parameters"; },
                        [](GarmentRef) -> std::string { return "a garment"; },
                        [](PieceRef) -> std::string { return "a piece"; },
                        [](InnerRef inner) -> std::string { return fmt::format("a {}", inner->kind()); },
                    },
                    value.data());
}

std::string signature(const Value& value) {
  const auto of = [](Dimension d) { return fmt::format("{},{},{},{}", d.length, d.mass, d.time, d.angle); };
  std::string text = std::to_string(value.kind());
  if (const auto* quantity = value.as<Quantity>()) text += ":" + of(quantity->dimension);
  if (const auto* point = value.as<Point>()) text += ":" + of(point->dimension);
  if (const auto* point = value.as<Point3>()) text += ":" + of(point->dimension);
  if (const auto* list = value.as<ListValue>(); list != nullptr && !list->items->empty()) {
    text += "[" + signature(list->items->front()) + "]";
  }
  if (const auto* record = value.as<RecordValue>()) {
    for (const RecordValue::Field& field : *record->fields)
      text += "(" + field.name + ":" + signature(field.value) + ")";
  }
  return text;
}

bool alike(const Value& a, const Value& b) {
  if (a.unknown() || b.unknown()) return true;
  if (a.as<ListValue>() != nullptr && b.as<ListValue>() != nullptr) {
    const auto& left = *a.as<ListValue>()->items;
    const auto& right = *b.as<ListValue>()->items;
    return left.empty() || right.empty() || alike(left.front(), right.front());
  }
  const auto* left = a.as<RecordValue>();
  const auto* right = b.as<RecordValue>();
  if (left != nullptr && right != nullptr) {
    return std::equal(left->fields->begin(), left->fields->end(), right->fields->begin(), right->fields->end(),
                      [](const auto& x, const auto& y) { return x.name == y.name && alike(x.value, y.value); });
  }
  return signature(a) == signature(b);
}

std::string format(const Value& value) {
  if (!value.known()) return describe(value);
  return std::visit(
      Overloaded{
          [](const Quantity& q) { return format_quantity(q.si, q.dimension, q.percent); },
          [](const Truth& truth) -> std::string { return truth.value ? "true" : "false"; },
          [](const Text& text) { return text.value; },
          [](const Colour& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); },
          [](const Point& p) {
            return fmt::format("({}, {})", format_quantity(p.at.x, p.dimension), format_quantity(p.at.y, p.dimension));
          },
          [](const Point3& p) {
            return fmt::format("({}, {}, {})", format_quantity(p.at[0], p.dimension),
                               format_quantity(p.at[1], p.dimension), format_quantity(p.at[2], p.dimension));
          },
          [](const PlaneCurve& c) {
            return "a curve " + format_quantity(c.curve->length(), dimension::length) + " long";
          },
          [](const ListValue& list) {
            std::string text;
            for (const Value& item : *list.items) text += (text.empty() ? "" : ", ") + format(item);
            return "[" + text + "]";
          },
          [](const RecordValue& record) {
            std::string text;
            for (const RecordValue::Field& field : *record.fields) {
              text += (text.empty() ? "" : ", ") + field.name + ": " + format(field.value);
            }
            return "(" + text + ")";
          },
          [](const BodyValue& body) { return "body " + body.body->spec.name; },
          [](const BodyLineValue& line) { return line.body->spec.name + "." + line.line; },
          [](const FabricValue& fabric) { return "fabric " + fabric.sheet->name; },
          [](const TextileValue& textile) { return "textile " + textile.textile->name; },
          [](GarmentRef garment) { return "garment " + garment->draft.name; },
          [](PieceRef piece) { return "piece " + piece->name; },
          [](InnerRef inner) { return fmt::format("{} {}", inner->kind(), inner->name); },
          [&](const auto&) { return describe(value); },
      },
      value.data());
}

}  // namespace toile
