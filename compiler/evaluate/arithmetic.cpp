#include "compiler/evaluate/arithmetic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "compiler/units/format.hpp"

namespace toile {
namespace {

using syntax::Kind;

constexpr double longest = 100;  // [m] beyond any garment

Value wrong_operands(Session& session, Kind op, const Operand& left, const Operand& right) {
  session.report.add(Problem("E0202", fmt::format("`{}` has no meaning between {} and {}", syntax::spelling(op),
                                                  describe(left.value), describe(right.value)))
                         .at(left.at, describe(left.value))
                         .at(right.at, describe(right.value)));
  return Unknown{};
}

std::string_view verb(Kind op) {
  switch (op) {
    case Kind::Plus:
      return "be added";
    case Kind::Minus:
      return "be subtracted";
    default:
      return "be compared";
  }
}

Dimension dimension_of(const Value& value) {
  if (const auto* quantity = value.as<Quantity>()) return quantity->dimension;
  if (const auto* point = value.as<Point>()) return point->dimension;
  if (const auto* point = value.as<Point3>()) return point->dimension;
  return {};
}

Value wrong_dimensions(Session& session, Kind op, const Operand& left, const Operand& right) {
  const Dimension a = dimension_of(left.value);
  const Dimension b = dimension_of(right.value);
  Problem problem("E0201", fmt::format("{} and {} cannot {}", describe(a), describe(b), verb(op)));
  problem.at(left.at, describe(a)).at(right.at, describe(b));
  const bool one_is_plain = a.plain() != b.plain();
  if (one_is_plain && (a == dimension::length || b == dimension::length)) {
    problem.help("every length has its unit: `2cm`, not `2`");
  } else if (one_is_plain && (a == dimension::angle || b == dimension::angle)) {
    problem.help("every angle has its unit: `12deg` or `0.2rad`");
  }
  // A unit that was forgotten is missing where the name is defined.
  const Operand& plain = a.plain() ? left : right;
  if (one_is_plain && plain.defined) problem.also(*plain.defined, "defined here");
  session.report.add(problem);
  return Unknown{};
}

Value sum(Session& session, Kind op, const Operand& left, const Operand& right) {
  const double sign = op == Kind::Plus ? 1 : -1;
  const bool known = left.value.known() && right.value.known();
  const bool points = left.value.as<Point>() != nullptr && right.value.as<Point>() != nullptr;
  const bool spatial = left.value.as<Point3>() != nullptr && right.value.as<Point3>() != nullptr;
  const auto* a = left.value.as<Quantity>();
  const auto* b = right.value.as<Quantity>();
  if ((a == nullptr || b == nullptr) && !points && !spatial) return wrong_operands(session, op, left, right);
  if (dimension_of(left.value) != dimension_of(right.value)) return wrong_dimensions(session, op, left, right);
  if (points) {
    const auto& p = *left.value.as<Point>();
    return {Point{p.dimension, p.at + sign * right.value.as<Point>()->at}, known};
  }
  if (spatial) {
    Point3 p = *left.value.as<Point3>();
    for (std::size_t i = 0; i < 3; ++i) p.at[i] += sign * right.value.as<Point3>()->at[i];
    return {p, known};
  }
  return {Quantity{a->dimension, a->si + sign * b->si, a->percent && b->percent}, known};
}

Value scaled(const Value& value, Dimension dim, double factor, bool known) {
  if (const auto* point = value.as<Point>()) return {Point{point->dimension * dim, factor * point->at}, known};
  Point3 p = *value.as<Point3>();
  p.dimension = p.dimension * dim;
  for (double& coordinate : p.at) coordinate *= factor;
  return {p, known};
}

bool is_vector(const Value& value) {
  return value.as<Point>() != nullptr || value.as<Point3>() != nullptr;
}

Value product(Session& session, const Operand& left, const Operand& right) {
  const bool known = left.value.known() && right.value.known();
  const auto* a = left.value.as<Quantity>();
  const auto* b = right.value.as<Quantity>();
  if (a != nullptr && b != nullptr) return {Quantity{a->dimension * b->dimension, a->si * b->si}, known};
  if (a != nullptr && is_vector(right.value)) return scaled(right.value, a->dimension, a->si, known);
  if (b != nullptr && is_vector(left.value)) return scaled(left.value, b->dimension, b->si, known);
  return wrong_operands(session, Kind::Star, left, right);
}

Value quotient(Session& session, const Operand& left, const Operand& right) {
  const bool known = left.value.known() && right.value.known();
  const auto* a = left.value.as<Quantity>();
  const auto* b = right.value.as<Quantity>();
  if (b == nullptr || (a == nullptr && !is_vector(left.value))) {
    return wrong_operands(session, Kind::Slash, left, right);
  }
  if (known && b->si == 0) {
    session.report.add(Problem("E0206", "division by zero")
                           .at(right.at, "this is zero")
                           .help("where it may be zero, ask first: if n == 0 then 0cm else length / n"));
    return Unknown{};
  }
  if (a == nullptr) return scaled(left.value, dimension::number / b->dimension, known ? 1 / b->si : 0, known);
  const Dimension dim = a->dimension / b->dimension;
  return {Quantity{dim, known ? a->si / b->si : 0}, known};
}

Value raised(Session& session, const Operand& left, const Operand& right) {
  const auto* base = left.value.as<Quantity>();
  const auto* exponent = right.value.as<Quantity>();
  if (base == nullptr || exponent == nullptr) return wrong_operands(session, Kind::Caret, left, right);
  const bool known = left.value.known() && right.value.known();
  if (!exponent->dimension.plain()) {
    session.report.add(Problem("E0205", "an exponent is a plain number, and this is " + describe(right.value))
                           .at(right.at, describe(right.value)));
    return Unknown{};
  }
  if (base->dimension.plain()) return {Quantity{{}, known ? std::pow(base->si, exponent->si) : 0}, known};
  if (!right.value.known()) return Unknown{};
  const double n = exponent->si;
  if (n != std::round(n) || std::abs(n) > 12) {
    session.report.add(Problem("E0205", fmt::format("{} can only be raised to a whole power", describe(left.value)))
                           .at(right.at)
                           .also(left.at, describe(left.value))
                           .help("for a square root write sqrt( )"));
    return Unknown{};
  }
  return {Quantity{power(base->dimension, static_cast<int>(n)), known ? std::pow(base->si, n) : 0}, known};
}

bool compare(Kind op, double a, double b) {
  switch (op) {
    case Kind::Less:
      return a < b;
    case Kind::LessEqual:
      return a <= b;
    case Kind::Greater:
      return a > b;
    default:
      return a >= b;
  }
}

const Value* field_called(const RecordValue& record, const std::string& name) {
  const auto found = std::ranges::find(*record.fields, name, &RecordValue::Field::name);
  return found == record.fields->end() ? nullptr : &found->value;
}

/// Whether two known values of the same kind are the same.
bool equal(const Value& a, const Value& b) {
  if (const auto* left = a.as<ListValue>()) {
    return std::ranges::equal(*left->items, *b.as<ListValue>()->items, equal);
  }
  if (const auto* left = a.as<RecordValue>()) {
    return std::ranges::all_of(*left->fields, [&](const RecordValue::Field& field) {
      return equal(field.value, *field_called(*b.as<RecordValue>(), field.name));
    });
  }
  if (const auto* left = a.as<Quantity>()) return left->si == b.as<Quantity>()->si;
  if (const auto* left = a.as<Truth>()) return left->value == b.as<Truth>()->value;
  if (const auto* left = a.as<Text>()) return left->value == b.as<Text>()->value;
  if (const auto* left = a.as<Colour>()) return *left == *b.as<Colour>();
  if (const auto* left = a.as<Point>()) return left->at == b.as<Point>()->at;
  return a.as<Point3>()->at == b.as<Point3>()->at;
}

bool has_equality(const Value& value) {
  return value.as<Quantity>() != nullptr || value.as<Truth>() != nullptr || value.as<Text>() != nullptr ||
         value.as<Colour>() != nullptr || is_vector(value);
}

/// Whether it can be asked if they are the same: values of one kind, lists of such, records with the same names.
bool are_comparable(const Value& a, const Value& b) {
  if (a.unknown() || b.unknown()) return true;
  if (a.kind() != b.kind()) return false;
  if (const auto* left = a.as<ListValue>()) {
    const auto& right = *b.as<ListValue>()->items;
    return left->items->empty() || right.empty() || are_comparable(left->items->front(), right.front());
  }
  if (const auto* left = a.as<RecordValue>()) {
    const auto* right = b.as<RecordValue>();
    return left->fields->size() == right->fields->size() &&
           std::ranges::all_of(*left->fields, [&](const RecordValue::Field& field) {
             const Value* other = field_called(*right, field.name);
             return other != nullptr && are_comparable(field.value, *other);
           });
  }
  return has_equality(a) && dimension_of(a) == dimension_of(b);
}

Value comparison(Session& session, Kind op, const Operand& left, const Operand& right) {
  const bool known = left.value.known() && right.value.known();
  const bool equality = op == Kind::Equal || op == Kind::NotEqual;
  const auto* a = left.value.as<Quantity>();
  const auto* b = right.value.as<Quantity>();
  const bool compound = left.value.as<ListValue>() != nullptr || left.value.as<RecordValue>() != nullptr;
  const bool alike = compound && are_comparable(left.value, right.value);
  const bool fits = equality ? left.value.kind() == right.value.kind() && (has_equality(left.value) || alike)
                             : a != nullptr && b != nullptr;
  if (!fits) return wrong_operands(session, op, left, right);
  if (dimension_of(left.value) != dimension_of(right.value)) return wrong_dimensions(session, op, left, right);
  if (!known) return {Truth{}, false};
  if (equality) return Truth{equal(left.value, right.value) == (op == Kind::Equal)};
  return Truth{compare(op, a->si, b->si)};
}

bool absurd(Dimension dim, double si) {
  return dim == dimension::length && std::abs(si) > longest;
}

}  // namespace

Value checked(Session& session, Value value, Location at) {
  if (!value.known()) return value;
  double largest = 0;
  bool finite = true;
  const auto look = [&](double coordinate) {
    finite = finite && std::isfinite(coordinate);
    if (std::abs(coordinate) > std::abs(largest)) largest = coordinate;
  };
  if (const auto* quantity = value.as<Quantity>()) {
    look(quantity->si);
  } else if (const auto* point = value.as<Point>()) {
    look(point->at.x);
    look(point->at.y);
  } else if (const auto* spatial = value.as<Point3>()) {
    for (const double coordinate : spatial->at) look(coordinate);
  } else {
    return value;
  }
  if (!finite) {
    session.report.add(Problem("E0206", "this is not a finite number").at(at));
    return Unknown{};
  }
  if (absurd(dimension_of(value), largest)) {
    session.report.add(Problem("E0207", fmt::format("{} is absurd: no length or coordinate of a garment exceeds 100 m",
                                                    format_quantity(largest, dimension::length)))
                           .at(at, "this is " + format_quantity(largest, dimension::length))
                           .help("is the unit right?"));
    return Unknown{};
  }
  return value;
}

Value apply_binary(Session& session, Kind op, const Operand& left, const Operand& right, Location whole) {
  if (left.value.unknown() || right.value.unknown()) {
    const bool truth = op >= Kind::Less && op <= Kind::NotEqual;
    return truth ? Value{Truth{}, false} : Value{Unknown{}};
  }
  switch (op) {
    case Kind::Plus:
    case Kind::Minus:
      return checked(session, sum(session, op, left, right), whole);
    case Kind::Star:
      return checked(session, product(session, left, right), whole);
    case Kind::Slash:
      return checked(session, quotient(session, left, right), whole);
    case Kind::Caret:
      return checked(session, raised(session, left, right), whole);
    default:
      return comparison(session, op, left, right);
  }
}

Value apply_minus(Session& session, const Operand& operand) {
  const Value& value = operand.value;
  if (value.unknown()) return value;
  if (const auto* q = value.as<Quantity>()) return {Quantity{q->dimension, -q->si, q->percent}, value.known()};
  if (is_vector(value)) return scaled(value, dimension::number, -1, value.known());
  session.report.add(Problem("E0202", "`-` has no meaning before " + describe(value)).at(operand.at, describe(value)));
  return Unknown{};
}

}  // namespace toile
