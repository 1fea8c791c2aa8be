// From a name to its value.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// The definition's value, computed now if it was not yet. A definition that is being computed already needs itself:
/// that is reported with the whole circle.
Value force(Session& session, Definition& definition);

/// `solve` tries values for its unknowns, and what is computed from one is stale with the next. Everything that runs
/// inside of the solve at that depth now depends on its value.
void note_try(Session& session, std::size_t depth);
/// The depth of the outermost solve whose value the innermost definition used so far; nothing when it used none.
std::optional<std::size_t> depth_of_try(const Session& session);
/// For a definition whose value comes from outside: it depends on what the innermost running one depends on.
void mark_try(const Session& session, Definition& definition);

/// What a name is wanted for. Before an argument list a function is preferred to a `param length` that hides it, and
/// where a curve is wanted an edge is preferred to a measure of the same name.
enum class Wish { Value, Function, Curve };

/// What a name means in a scope. Unknown names are reported with the nearest known one.
Value look_up(Session& session, const Scope& scope, const syntax::Token& name, Wish wish);

/// `object.name` for every kind of object that has fields.
Value member(Session& session, const Scope& scope, const Value& object, const syntax::Token& name, Location object_at);

/// Defines a name in a block; a second definition of it is an error that shows both.
Definition* define(Session& session, Scope& scope, const std::optional<syntax::Token>& name,
                   std::function<Value()> compute);
/// The same for a name that is written in another module.
Definition* define(Session& session, Scope& scope, const Module& module, const std::optional<syntax::Token>& name,
                   std::function<Value()> compute);

/// "no piece `frnt`": reports a name that one of `known` was meant by.
void report_unknown(Session& session, const Module& module, const syntax::Token& name, const std::string& message,
                    const std::vector<std::string>& known, const std::string& code = "E0101");

}  // namespace toile
