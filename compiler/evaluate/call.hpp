// Calls: which argument belongs to which parameter, and what comes of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// A parameter as callers see it.
struct Formal {
  std::string name;
  bool optional = false;
  bool curve = false;  // wants one
};

struct Given {
  Value value;
  Location at;
};

/// The arguments by parameter, in the order of `formals`; absent ones are empty. With `variadic` the last parameter
/// takes any number, so that there may be more entries than formals. Nothing when they do not fit: an unknown, missing
/// or repeated one is reported.
std::optional<std::vector<std::optional<Given>>> bind_arguments(Session& session, const Scope& scope,
                                                                const syntax::Call& written, const std::string& callee,
                                                                const std::vector<Formal>& formals,
                                                                bool variadic = false);

/// Defines the parameters of a function, body or garment in the scope of its call: what was given, else the default
/// evaluated there. `arguments` has one entry a parameter, or none at all for a call without any.
void define_parameters(Session& session, Scope& inside, const syntax::Parameters& parameters,
                       const std::vector<std::optional<Given>>& arguments);

std::vector<Formal> formals_of(const Session& session, const Module& module,
                               const std::optional<syntax::Parameters>& parameters);

/// `callee(arguments)`: a built-in, a `fn`, or a body or garment with parameters.
Value call(Session& session, const Scope& scope, const syntax::Call& written);

/// Evaluates a function that nothing may ever call, with parameters of which only the defaults' kinds are known.
void check_function(Session& session, const UserFunction& function);

}  // namespace toile
