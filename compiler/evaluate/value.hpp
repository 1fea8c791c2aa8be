// What an expression may stand for. A value knows its kind and its dimension always, its magnitude only when that is
// there: before a drape its result's fields have units but no numbers, and a branch that is not taken is checked in the
// same way. One evaluator thus both checks and computes.
#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/curve/curve.hpp"
#include "compiler/pattern/fabric_sheet.hpp"
#include "compiler/pattern/textile.hpp"
#include "compiler/units/dimension.hpp"

namespace toile {

class Value;
struct Module;
struct Builtin;
struct UserFunction;
struct BodyTemplate;
struct GarmentTemplate;
struct PieceTemplate;
struct BodyInstance;
struct ChartSpec;
struct GarmentInstance;
struct PieceInstance;
struct InnerInstance;
struct DrapeRecord;

/// Nothing can be said of it: a mistake was reported where it comes from, or its function's argument is not known yet.
/// Whatever is made of it is unknown again, in silence.
struct Unknown {};

struct Quantity {
  Dimension dimension;
  double si = 0;
  bool percent = false;  // shown in %
};
struct Truth {
  bool value = false;
};
struct Text {
  std::string value;
};
/// A point or a vector in the plane; its coordinates have one dimension.
struct Point {
  Dimension dimension;
  Vec2 at;
};
struct Point3 {
  Dimension dimension;
  std::array<double, 3> at{};
};
struct PlaneCurve {
  std::shared_ptr<const Curve> curve;  // null when not known
};
/// A list whose length is not known holds one element that stands for all, or none.
struct ListValue {
  std::shared_ptr<const std::vector<Value>> items;
};
/// Named values, in the order in which they were written.
struct RecordValue {
  struct Field;
  std::shared_ptr<const std::vector<Field>> fields;
};
struct BodyValue {
  std::shared_ptr<BodyInstance> body;
};
struct BodyLineValue {
  std::shared_ptr<BodyInstance> body;
  std::string line;
};
/// A map of a body's surface to the plane, in which pieces are drawn.
struct ChartValue {
  std::shared_ptr<BodyInstance> body;
  std::shared_ptr<const ChartSpec> spec;
};
struct FabricValue {
  std::shared_ptr<const FabricSheet> sheet;
};
struct TextileValue {
  std::shared_ptr<const Textile> textile;
};
/// The fields of a drape whose names begin with `prefix` ("contact.").
struct ResultValue {
  const DrapeRecord* drape = nullptr;
  std::string prefix;
};

/// Things that live as long as the session and are referred to.
using FunctionRef = const UserFunction*;
using BuiltinRef = const Builtin*;
using ModuleRef = Module*;
using BodyTemplateRef = const BodyTemplate*;
using GarmentTemplateRef = const GarmentTemplate*;
using PieceTemplateRef = const PieceTemplate*;
using GarmentRef = GarmentInstance*;
using PieceRef = PieceInstance*;
using InnerRef = const InnerInstance*;

class Value {
 public:
  using Data =
      std::variant<Unknown, Quantity, Truth, Text, Colour, Point, Point3, PlaneCurve, ListValue, RecordValue, BodyValue,
                   BodyLineValue, ChartValue, FabricValue, TextileValue, ResultValue, FunctionRef, BuiltinRef,
                   ModuleRef, BodyTemplateRef, GarmentTemplateRef, PieceTemplateRef, GarmentRef, PieceRef, InnerRef>;

  Value() = default;
  template <typename T>
  requires(std::constructible_from<Data, T> && !std::same_as<T, Value>)
      Value(T data, bool is_known = true)  // NOLINT(google-explicit-constructor): every alternative is a value
      : data_(std::move(data)), known_(is_known) {}

  const Data& data() const { return data_; }
  template <typename T>
  const T* as() const {
    return std::get_if<T>(&data_);
  }
  bool unknown() const { return std::holds_alternative<Unknown>(data_); }
  /// Whether its magnitude is there, too.
  bool known() const { return known_ && !unknown(); }
  std::size_t kind() const { return data_.index(); }

 private:
  Data data_;
  bool known_ = true;
};

struct RecordValue::Field {
  std::string name;
  Value value;
};

/// A plain number, and a length.
Value number(double value, bool known = true);
Value metres(double value, bool known = true);
Value curve_value(Curve curve);
Value list_value(std::vector<Value> items, bool known = true);
/// Known as far as all of its fields are.
Value record_value(std::vector<RecordValue::Field> fields);

/// The same value without its magnitude. Things that have none (a fabric, a function, a text) stay as they are.
Value forget(const Value& value);

/// In words with the article, for messages: "a length", "a curve", "a list".
std::string describe(const Value& value);

/// Kind and dimension as a short text: equal for values that expressions treat alike.
std::string signature(const Value& value);

/// Whether both have the same kind and dimension, as the branches of an `if` must; the unknown fits with everything.
bool alike(const Value& a, const Value& b);

/// As `print` writes it: "68 cm", "(3 cm, 0 cm)", "a curve 23.4 cm long".
std::string format(const Value& value);

}  // namespace toile
