#include "compiler/evaluate/repetition.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/names.hpp"

namespace toile {
namespace {

constexpr std::size_t longest_list = 10'000;

/// What the variable runs through; one value without magnitude when that is not known.
std::optional<std::vector<Value>> values_of(Session& session, const Scope& scope, const syntax::For& written) {
  const Module& module = scope.module();
  const auto from_expr = written.from();
  const auto to_expr = written.to();
  const Value from = evaluate(session, scope, from_expr);
  if (!to_expr) {
    if (from.unknown()) return std::nullopt;
    if (const auto* given = from.as<ListValue>()) return *given->items;
    session.report.add(Problem("E0202", "`for` runs through a list or a range, and this is " + describe(from))
                           .at(module.at(*from_expr), describe(from))
                           .help("write `for i in 1..4`"));
    return std::nullopt;
  }
  const Value to = evaluate(session, scope, to_expr);
  if (!whole_number(session, module, from, *from_expr) || !whole_number(session, module, to, *to_expr)) {
    return std::nullopt;
  }
  if (!from.known() || !to.known()) return std::vector<Value>{number(0, false)};
  const double first = from.as<Quantity>()->si;
  const double last = to.as<Quantity>()->si;
  if (last - first >= static_cast<double>(longest_list)) {
    session.report.add(Problem("E0113", fmt::format("a list of more than {} elements", longest_list))
                           .at({module.file, {from_expr->span().begin, to_expr->span().end}}));
    return std::nullopt;
  }
  std::vector<Value> values;
  const int steps = last < first ? -1 : static_cast<int>(last - first);  // below the bound just checked
  for (int i = 0; i <= steps; ++i) values.push_back(number(first + i));
  return values;
}

}  // namespace

std::optional<bool> for_each_value(Session& session, const Scope& scope, const syntax::For& written,
                                   const std::function<void(const Scope&)>& body) {
  std::vector<std::unique_ptr<Scope>> passing;
  return for_each_value(session, scope, written, passing, [&](const Scope& inner) {
    body(inner);
    passing.clear();
  });
}

std::optional<bool> for_each_value(Session& session, const Scope& scope, const syntax::For& written,
                                   std::vector<std::unique_ptr<Scope>>& kept,
                                   const std::function<void(const Scope&)>& body) {
  const Module& module = scope.module();
  const std::optional<std::vector<Value>> values = values_of(session, scope, written);
  const auto variable = written.name();
  if (!values || !variable) return std::nullopt;
  bool known = true;
  for (const Value& each : *values) {
    kept.push_back(std::make_unique<Scope>(scope.module(), &scope, true, signature(each)));
    Scope& inner = *kept.back();
    inner.define_value(session.name_of(module, variable), module.at(*variable), each);
    mark_try(session, *inner.definitions().back());
    if (const auto condition = written.condition()) {
      const std::optional<Value> wanted =
          truth_of(session, module, evaluate(session, inner, condition), *condition, "`if`");
      if (!wanted) return std::nullopt;
      known = known && wanted->known();
      if (wanted->known() && !wanted->as<Truth>()->value) continue;
    }
    body(inner);
    if (session.exhausted) return std::nullopt;
  }
  return known;
}

std::optional<std::vector<std::string>> path_of(Session& session, const Scope& scope, const syntax::View& reference) {
  std::vector<std::string> names;
  const Module& module = scope.module();
  for (const syntax::View part : syntax::children(reference)) {
    if (part.kind() == syntax::Kind::Name) names.emplace_back(session.text(module, part));
    const auto which = syntax::as<syntax::Which>(part);
    if (!which) continue;
    const auto expr = which->number();
    const Value number = evaluate(session, scope, expr);
    if (names.empty() || !whole_number(session, module, number, *expr)) return std::nullopt;
    if (number.known()) names.back() += fmt::format("{:.0f}", number.as<Quantity>()->si);
  }
  return names;
}

std::optional<Value> truth_of(Session& session, const Module& module, const Value& condition,
                              const syntax::Expr& written, const std::string& whose) {
  if (condition.unknown()) return std::nullopt;
  if (condition.as<Truth>() != nullptr) return condition;
  session.report.add(Problem("E0202", whose + " needs true or false, and this is " + describe(condition))
                         .at(module.at(written), describe(condition))
                         .help("compare it with something: `a < b`"));
  return std::nullopt;
}

bool whole_number(Session& session, const Module& module, const Value& candidate, const syntax::Expr& written) {
  if (candidate.unknown()) return false;
  const auto* q = candidate.as<Quantity>();
  if (q != nullptr && q->dimension.plain() && (!candidate.known() || q->si == std::round(q->si))) return true;
  const std::string found = q != nullptr && q->dimension.plain() ? format(candidate) : describe(candidate);
  session.report.add(Problem("E0202", "a whole number is wanted, and this is " + found).at(module.at(written), found));
  return false;
}

}  // namespace toile
