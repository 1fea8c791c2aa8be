#include "compiler/evaluate/expression.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <map>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/arithmetic.hpp"
#include "compiler/evaluate/call.hpp"
#include "compiler/evaluate/literals.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/repetition.hpp"
#include "compiler/units/unit.hpp"

namespace toile {
namespace {

using syntax::Kind;

// Bounds of depth: the first is met in an ordinary build; the second keeps builds with larger frames from overflowing.
constexpr int deepest = 1000;                  // expressions inside of expressions, definitions and calls included
constexpr std::intptr_t most_stack = 5 << 20;  // [bytes] of 8 MiB
constexpr long most_steps = 500'000;           // expressions evaluated in all

/// One expression being evaluated; keeps count of depth and steps.
class Step {
 public:
  Step(Session& session, const Scope& scope, const syntax::Expr& expr) : session_(session) {
    ++session.depth;
    ++session.steps;
    if (session.depth == 1) session.stack_base = stack_place();
    const bool too_deep = session.depth > deepest || session.stack_base - stack_place() > most_stack;
    if (session.exhausted || (!too_deep && session.steps <= most_steps)) return;
    session.exhausted = true;
    session.report.add(Problem("E0113", session.steps > most_steps ? "this script takes too many steps to evaluate"
                                                                   : "definitions and calls are nested too deeply here")
                           .at(scope.module().at(expr)));
  }
  ~Step() {
    if (--session_.depth == 0 && session_.steps <= most_steps) session_.exhausted = false;
  }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

 private:
  static std::intptr_t stack_place() { return reinterpret_cast<std::intptr_t>(__builtin_frame_address(0)); }

  Session& session_;
};

/// One evaluation: the places of its operands are wanted again and again.
class Evaluation {
 public:
  Evaluation(Session& session, const Scope& scope) : session_(session), scope_(scope), module_(scope.module()) {}

  Value of(const syntax::Expr& expr) {
    switch (expr.kind()) {
      case Kind::If:
        return choice(*syntax::as<syntax::If>(expr));
      case Kind::Binary:
        return binary(*syntax::as<syntax::Binary>(expr));
      case Kind::Unary:
        return unary(*syntax::as<syntax::Unary>(expr));
      case Kind::Member:
        return field(*syntax::as<syntax::Member>(expr));
      case Kind::Call:
        return call(session_, scope_, *syntax::as<syntax::Call>(expr));
      case Kind::Index:
        return element(*syntax::as<syntax::Index>(expr));
      case Kind::NameRef:
        return name(*syntax::as<syntax::NameRef>(expr));
      case Kind::Number:
        return quantity(*syntax::as<syntax::Number>(expr));
      case Kind::String:
        return written_text(session_, scope_, *syntax::as<syntax::String>(expr));
      case Kind::Colour:
        return written_colour(session_, module_, expr);
      case Kind::Boolean:
        return Truth{syntax::as<syntax::Boolean>(expr)->value()};
      case Kind::Tuple:
        return tuple(*syntax::as<syntax::Tuple>(expr));
      case Kind::RecordLiteral:
        return record(*syntax::as<syntax::RecordLiteral>(expr));
      case Kind::List:
        return list(*syntax::as<syntax::List>(expr));
      default:
        return Unknown{};
    }
  }

 private:
  Location at(const syntax::View& view) const { return module_.at(view); }
  Value value(const std::optional<syntax::Expr>& expr) { return evaluate(session_, scope_, expr); }
  Value supposed(const std::optional<syntax::Expr>& expr) { return suppose(session_, scope_, expr); }

  Value name(const syntax::NameRef& ref) {
    const auto token = ref.name();
    return token ? look_up(session_, scope_, *token, Wish::Value) : Value{};
  }

  Value quantity(const syntax::Number& literal) {
    const auto digits = literal.digits();
    if (!digits) return Unknown{};
    const double value = syntax::number_value(*digits, session_.sources[module_.file]);
    const auto unit_token = literal.unit();
    if (!unit_token) return checked(session_, number(value), at(literal));
    const std::string_view text = session_.text(module_, *unit_token);
    const std::optional<Unit> unit = parse_unit(text);
    if (unit) {
      return checked(session_, Quantity{unit->dimension, value * unit->factor, unit->percent}, at(literal));
    }
    const std::string_view part = unknown_unit_part(text);
    session_.report.add(Problem("E0204", fmt::format("`{}` is no unit", part))
                            .at(at(*unit_token))
                            .help(suggestion(part, unit_names())));
    return Unknown{};
  }

  Value unary(const syntax::Unary& expr) {
    const auto op = expr.op();
    const auto operand = expr.operand();
    if (!op || !operand) return Unknown{};
    const Value value_of_operand = value(operand);
    if (op->kind() == Kind::Minus) return apply_minus(session_, {value_of_operand, at(*operand)});
    const std::optional<Value> truth = truth_of(session_, module_, value_of_operand, *operand, "`not`");
    if (!truth) return Unknown{};
    return {Truth{!truth->as<Truth>()->value}, truth->known()};
  }

  Value binary(const syntax::Binary& expr) {
    const auto op = expr.op();
    const auto left = expr.left();
    const auto right = expr.right();
    if (!op || !left || !right) return Unknown{};
    if (op->kind() == Kind::KwAnd || op->kind() == Kind::KwOr) return logical(op->kind(), *left, *right);
    const Value a = value(left);
    const Value b = value(right);
    return apply_binary(session_, op->kind(), {a, at(*left), defined(*left)}, {b, at(*right), defined(*right)},
                        at(expr));
  }

  /// Where a name that stands alone is defined.
  std::optional<Location> defined(const syntax::Expr& expr) const {
    const auto ref = syntax::as<syntax::NameRef>(expr);
    if (!ref || !ref->name()) return std::nullopt;
    const Definition* found = scope_.find(session_.text(module_, *ref->name()));
    return found == nullptr ? std::nullopt : std::optional(found->at);
  }

  Value logical(Kind op, const syntax::Expr& left, const syntax::Expr& right) {
    const std::string whose = "`" + std::string(syntax::spelling(op)) + "`";
    const std::optional<Value> a = truth_of(session_, module_, value(left), left, whose);
    const bool decided = a && a->known() && a->as<Truth>()->value == (op == Kind::KwOr);
    const std::optional<Value> b = truth_of(session_, module_, decided ? supposed(right) : value(right), right, whose);
    if (decided) return *a;
    if (!a || !b) return {Truth{}, false};
    return {Truth{b->as<Truth>()->value}, a->known() && b->known()};
  }

  Value choice(const syntax::If& expr) {
    const auto condition_expr = expr.condition();
    const auto then_expr = expr.then();
    const auto else_expr = expr.otherwise();
    if (!condition_expr || !then_expr || !else_expr) return Unknown{};
    const std::optional<Value> condition = truth_of(session_, module_, value(condition_expr), *condition_expr, "`if`");
    const bool decided = condition && condition->known();
    const bool taken = decided && condition->as<Truth>()->value;
    const Value yes = decided && taken ? value(then_expr) : supposed(then_expr);
    const Value no = decided && !taken ? value(else_expr) : supposed(else_expr);
    if (!alike(yes, no)) {
      const std::string a = describe(yes);
      const std::string b = describe(no);
      session_.report.add(Problem("E0202", "the branches of `if` differ: " + a + " or " + b)
                              .at(at(*then_expr), a)
                              .at(at(*else_expr), b));
      return Unknown{};
    }
    if (decided) return taken ? yes : no;
    return yes.unknown() ? forget(no) : forget(yes);
  }

  Value field(const syntax::Member& expr) {
    const auto object = expr.object();
    const auto name_token = expr.name();
    if (!object) return Unknown{};
    const Value of_object = value(object);
    if (!name_token) return Unknown{};
    const Value found = member(session_, scope_, of_object, *name_token, at(*object));
    return session_.supposing > 0 ? forget(found) : found;
  }

  Value tuple(const syntax::Tuple& expr) {
    const std::vector<syntax::Expr> parts = expr.parts();
    if (parts.size() == 1) return value(parts[0]);
    std::array<double, 3> coordinates{};
    std::optional<Dimension> shared;
    bool known = true;
    bool sound = parts.size() == 2 || parts.size() == 3;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Value part = value(parts[i]);
      const auto* q = part.as<Quantity>();
      if (q == nullptr) {
        sound = false;
        if (part.unknown()) continue;
        session_.report.add(Problem("E0202", "a coordinate is a length, and this is " + describe(part))
                                .at(at(parts[i]), describe(part)));
        continue;
      }
      if (shared && *shared != q->dimension) {
        sound = false;
        session_.report.add(Problem("E0201", "the coordinates of a point must have one dimension, here " +
                                                 describe(*shared) + " and " + describe(q->dimension))
                                .at(at(parts[0]), describe(*shared))
                                .at(at(parts[i]), describe(q->dimension))
                                .help(q->dimension.plain() || shared->plain() ? "write `0cm`, not `0`" : ""));
        continue;
      }
      shared = q->dimension;
      known = known && part.known();
      if (i < 3) coordinates[i] = q->si;
    }
    if (!sound) return Unknown{};
    if (parts.size() == 2) return {Point{*shared, {coordinates[0], coordinates[1]}}, known};
    return {Point3{*shared, coordinates}, known};
  }

  Value record(const syntax::RecordLiteral& expr) {
    std::vector<RecordValue::Field> fields;
    std::map<std::string, Location> places;
    bool sound = true;
    for (const syntax::Argument& written : expr.fields()) {
      if (written.spread() || !written.name()) continue;
      std::string text = session_.name_of(module_, written.name());
      const Location place = at(*written.name());
      const auto [earlier, is_new] = places.try_emplace(text, place);
      if (!is_new) {
        session_.report.add(Problem("E0102", "field `" + text + "` is given twice")
                                .at(place, "given again here")
                                .also(earlier->second, "already given here"));
        continue;
      }
      fields.push_back({std::move(text), value(written.value())});
    }
    for (const syntax::Argument& written : expr.fields()) {
      if (written.spread()) sound = add_fields_of(written, fields) && sound;
    }
    return sound ? record_value(std::move(fields)) : Value{};
  }

  /// Those of another record that are not there yet.
  bool add_fields_of(const syntax::Argument& written, std::vector<RecordValue::Field>& fields) {
    const Value other = value(written.value());
    if (other.unknown()) return false;
    const auto* record = other.as<RecordValue>();
    if (record == nullptr) {
      session_.report.add(
          Problem("E0202", "only a record's values are taken over by `...`, and this is " + describe(other))
              .at(at(written), describe(other)));
      return false;
    }
    for (const RecordValue::Field& field : *record->fields) {
      const auto same = [&](const RecordValue::Field& own) { return own.name == field.name; };
      if (std::ranges::none_of(fields, same)) fields.push_back(field);
    }
    return true;
  }

  Value list(const syntax::List& expr) {
    const std::vector<syntax::Expr> elements = expr.elements();
    const auto generator = expr.generator();
    if (generator) return elements.empty() ? Value{} : comprehension(*generator, elements.front());
    std::vector<Value> items;
    bool known = true;
    for (const syntax::Expr& element_expr : elements) {
      items.push_back(value(element_expr));
      known = known && items.back().known();
      if (alike(items.front(), items.back())) continue;
      const std::string first = describe(items.front());
      const std::string other = describe(items.back());
      session_.report.add(
          Problem("E0202", fmt::format("the elements of a list are of one kind, here {} and {}", first, other))
              .at(at(elements.front()), first)
              .at(at(element_expr), other));
      return Unknown{};
    }
    // A list with an element that is not known keeps its length and its other elements.
    return list_value(std::move(items), known);
  }

  Value comprehension(const syntax::For& generator, const syntax::Expr& element_expr) {
    std::vector<Value> items;
    bool all_known = true;
    const auto known = for_each_value(session_, scope_, generator, [&](const Scope& inner) {
      items.push_back(evaluate(session_, inner, element_expr));
      all_known = all_known && items.back().known();
    });
    return known ? list_value(std::move(items), *known && all_known) : Value{};
  }

  Value element(const syntax::Index& expr) {
    const auto object = expr.object();
    const auto index_expr = expr.index();
    const Value sequence = value(object);
    const Value index = value(index_expr);
    if (sequence.unknown() || index.unknown()) return Unknown{};
    const auto* items = sequence.as<ListValue>();
    if (items == nullptr) {
      session_.report.add(Problem("E0202", "only a list has elements, and this is " + describe(sequence))
                              .at(at(*object), describe(sequence)));
      return Unknown{};
    }
    if (!whole_number(session_, module_, index, *index_expr)) return Unknown{};
    const std::vector<Value>& all = *items->items;
    const double place = index.as<Quantity>()->si;
    if (session_.supposing > 0 || !index.known()) return all.empty() ? Value{} : forget(all.front());
    if (place >= 1 && place <= static_cast<double>(all.size())) return all[static_cast<std::size_t>(place) - 1];
    session_.report.add(Problem("E0209", fmt::format("element {} of a list of {}", format(index), all.size()))
                            .at(at(*index_expr))
                            .also(at(*object), fmt::format("{} elements", all.size()))
                            .help("elements count from 1"));
    return Unknown{};
  }

  Session& session_;
  const Scope& scope_;
  const Module& module_;
};

}  // namespace

Value evaluate(Session& session, const Scope& scope, const syntax::Expr& expr) {
  const Step step(session, scope, expr);
  if (session.exhausted) return Unknown{};
  return Evaluation(session, scope).of(expr);
}

Value evaluate(Session& session, const Scope& scope, const std::optional<syntax::Expr>& expr) {
  return expr ? evaluate(session, scope, *expr) : Value{};
}

Value evaluate_curve(Session& session, const Scope& scope, const std::optional<syntax::Expr>& expr) {
  if (!expr) return Unknown{};
  const auto ref = syntax::as<syntax::NameRef>(*expr);
  if (!ref || !ref->name()) return evaluate(session, scope, *expr);
  return look_up(session, scope, *ref->name(), Wish::Curve);
}

Value suppose(Session& session, const Scope& scope, const std::optional<syntax::Expr>& expr) {
  if (!expr) return Unknown{};
  const auto key = std::tuple(scope.module().file, expr->id, scope.signature());
  if (const auto found = session.supposed_branches.find(key); found != session.supposed_branches.end()) {
    return found->second;
  }
  session.supposed_branches[key] = Value{};  // what a recursion that comes by here again sees
  const Holding<int> supposing(session.supposing, session.supposing + 1);
  Value value = forget(evaluate(session, scope, *expr));
  session.supposed_branches[key] = value;
  return value;
}

}  // namespace toile
