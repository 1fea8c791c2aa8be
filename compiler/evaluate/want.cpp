#include "compiler/evaluate/want.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/evaluate/expression.hpp"
#include "compiler/units/format.hpp"

namespace toile {

void Wanted::wrong(const syntax::Expr& expr, const Value& value, const std::string& what,
                   const std::string& wanted) const {
  const std::string found = describe(value);
  const auto* q = value.as<Quantity>();
  Problem problem(q != nullptr ? "E0201" : "E0202", fmt::format("{} is {}, and this is {}", what, wanted, found));
  problem.at(scope.module().at(expr), found);
  if (q != nullptr && q->dimension.plain() && wanted == describe(dimension::length)) {
    problem.help("every length has its unit: `2cm`, not `2`");
  } else if (q != nullptr && q->dimension.plain() && wanted == describe(dimension::angle)) {
    problem.help("every angle has its unit: `12deg` or `0.2rad`");
  }
  session.report.add(problem);
}

bool Wanted::there(const syntax::Expr& expr, const Value& value, const std::string& what) const {
  if (value.known()) return true;
  if (!session.report.has_errors()) {
    session.report.add(Problem("E0506", what + " cannot depend on a drape's result: patterns are drawn before")
                           .at(scope.module().at(expr)));
  }
  return false;
}

std::optional<double> Wanted::quantity(const std::optional<syntax::Expr>& expr, Dimension dim, const std::string& what,
                                       Value* shown) const {
  const Value value = evaluate(session, scope, expr);
  if (value.unknown()) return std::nullopt;
  const auto* found = value.as<Quantity>();
  if (found == nullptr || found->dimension != dim) {
    wrong(*expr, value, what, describe(dim));
    return std::nullopt;
  }
  if (!there(*expr, value, what)) return std::nullopt;
  if (shown != nullptr) *shown = value;
  return found->si;
}

std::optional<double> Wanted::positive(const std::optional<syntax::Expr>& expr, Dimension dim,
                                       const std::string& what) const {
  Value value;
  const std::optional<double> si = quantity(expr, dim, what, &value);
  if (!si || *si > 0) return si;
  session.report.add(Problem("E0208", fmt::format("{} must be positive, and this is {}", what, format(value)))
                         .at(scope.module().at(*expr), "this is " + format(value)));
  return std::nullopt;
}

std::optional<double> Wanted::not_negative(const std::optional<syntax::Expr>& expr, Dimension dim,
                                           const std::string& what) const {
  Value value;
  const std::optional<double> si = quantity(expr, dim, what, &value);
  if (!si || *si >= 0) return si;
  session.report.add(Problem("E0208", fmt::format("{} cannot be negative, and this is {}", what, format(value)))
                         .at(scope.module().at(*expr), "this is " + format(value)));
  return std::nullopt;
}

std::optional<int> Wanted::count(const std::optional<syntax::Expr>& expr, const std::string& what, int most) const {
  const std::optional<double> number = positive(expr, dimension::number, what);
  if (!number || (*number == std::round(*number) && *number <= most)) {
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
  }
  session.report.add(Problem("E0209", fmt::format("{} is a whole number up to {}", what, most))
                         .at(scope.module().at(*expr), "this is " + format_number(*number)));
  return std::nullopt;
}

std::optional<FabricSheet> Wanted::fabric(const syntax::Expr& expr) const {
  const Value value = evaluate(session, scope, expr);
  if (const auto* fabric = value.as<FabricValue>()) return *fabric->sheet;
  if (value.unknown()) return std::nullopt;
  session.report.add(Problem("E0202", "a fabric is wanted here, and this is " + describe(value))
                         .at(scope.module().at(expr), describe(value)));
  return std::nullopt;
}

std::optional<Vec2> Wanted::point(const std::optional<syntax::Expr>& expr, const std::string& what) const {
  const Value value = evaluate(session, scope, expr);
  if (value.unknown()) return std::nullopt;
  const auto* found = value.as<Point>();
  if (found == nullptr) {
    wrong(*expr, value, what, "a point");
    return std::nullopt;
  }
  if (found->dimension != dimension::length) {
    session.report.add(
        Problem("E0201", "the coordinates of a point are lengths, and here " + describe(found->dimension))
            .at(scope.module().at(*expr))
            .help("write `(0cm, 0cm)`, not `(0, 0)`"));
    return std::nullopt;
  }
  if (!there(*expr, value, what)) return std::nullopt;
  return found->at;
}

std::optional<std::string> Wanted::text(const std::optional<syntax::Expr>& expr, const std::string& what) const {
  const Value value = evaluate(session, scope, expr);
  if (value.unknown()) return std::nullopt;
  if (const auto* found = value.as<Text>()) return found->value;
  wrong(*expr, value, what, "a text in quotes");
  return std::nullopt;
}

}  // namespace toile
