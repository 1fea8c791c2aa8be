// Expressions to values.
#pragma once

#include <optional>
#include <string>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// The value of an expression seen from a scope. Mistakes are reported and give Unknown; an expression that the parser
/// could not read is Unknown without another word.
Value evaluate(Session& session, const Scope& scope, const syntax::Expr& expr);
Value evaluate(Session& session, const Scope& scope, const std::optional<syntax::Expr>& expr);

/// The same where a curve is wanted: a bare name means an edge first.
Value evaluate_curve(Session& session, const Scope& scope, const std::optional<syntax::Expr>& expr);

/// The same in supposition: kinds and dimensions are checked, nothing is computed.
Value suppose(Session& session, const Scope& scope, const std::optional<syntax::Expr>& expr);

}  // namespace toile
