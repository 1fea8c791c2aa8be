// Expressions of which a certain kind is wanted: the width of a dart, a section's girth, the count of a cut. Each
// reader gives nothing after an error (reported by it or where the value comes from).
#pragma once

#include <optional>
#include <string>

#include "compiler/evaluate/session.hpp"

namespace toile {

struct Wanted {
  Session& session;
  const Scope& scope;

  /// A quantity of that dimension [SI]. `what` names it with the article: "the width of a dart".
  std::optional<double> quantity(const std::optional<syntax::Expr>& expr, Dimension dimension, const std::string& what,
                                 Value* shown = nullptr) const;
  std::optional<double> positive(const std::optional<syntax::Expr>& expr, Dimension dimension,
                                 const std::string& what) const;
  std::optional<double> not_negative(const std::optional<syntax::Expr>& expr, Dimension dimension,
                                     const std::string& what) const;
  std::optional<FabricSheet> fabric(const syntax::Expr& expr) const;
  std::optional<int> count(const std::optional<syntax::Expr>& expr, const std::string& what, int most = 1000) const;
  /// A point of lengths.
  std::optional<Vec2> point(const std::optional<syntax::Expr>& expr, const std::string& what) const;
  std::optional<std::string> text(const std::optional<syntax::Expr>& expr, const std::string& what) const;

  /// Reports that a value of the wrong kind stands where `wanted` ("a length") should.
  void wrong(const syntax::Expr& expr, const Value& value, const std::string& what, const std::string& wanted) const;
  /// Whether the magnitude is there. That of a drape's result is not when the pattern is drawn: reported.
  bool there(const syntax::Expr& expr, const Value& value, const std::string& what) const;
};

}  // namespace toile
