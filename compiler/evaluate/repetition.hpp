// `for`: the same once for each value of a variable.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Calls `body` with a scope that has the variable of `written`, for each of its values that the condition lets pass.
/// Whether the values and conditions were known: where not, `body` saw values without magnitude. Nothing after a
/// mistake, which is reported.
std::optional<bool> for_each_value(Session& session, const Scope& scope, const syntax::For& written,
                                   const std::function<void(const Scope&)>& body);

/// The same with scopes that are to outlive the call: they are put at the end of `kept`.
std::optional<bool> for_each_value(Session& session, const Scope& scope, const syntax::For& written,
                                   std::vector<std::unique_ptr<Scope>>& kept,
                                   const std::function<void(const Scope&)>& body);

/// The names behind each other in `front.side` or `panel[2].edge[i]`, what a `for` has made with its number: "panel2",
/// "edge3". Nothing after a mistake, which is reported.
std::optional<std::vector<std::string>> path_of(Session& session, const Scope& scope, const syntax::View& reference);

/// A truth as it stands, or an error.
std::optional<Value> truth_of(Session& session, const Module& module, const Value& condition,
                              const syntax::Expr& written, const std::string& whose);

/// Whether it is a whole number, as far as is known; if not that is reported.
bool whole_number(Session& session, const Module& module, const Value& candidate, const syntax::Expr& written);

}  // namespace toile
