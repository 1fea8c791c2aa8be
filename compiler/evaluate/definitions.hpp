// Statements that define names: import, param, let, fn, and the blocks.
#pragma once

#include <string>

#include "compiler/evaluate/session.hpp"

namespace toile {

void define_let(Session& session, Scope& scope, const syntax::Let& written);
void define_function(Session& session, Scope& scope, const syntax::Fn& written);
/// `prefix` stands before the name where settings speak of it: "skirt." for a garment's own parameters.
void define_param(Session& session, Scope& scope, const syntax::Param& written, const std::string& prefix);

/// Everything that a module defines; its commands are gathered.
void define_module(Session& session, Module& module);

/// Evaluates all that the module defines, so that every mistake is found whether or not a command comes by.
void check_module(Session& session, Module& module);

/// Evaluates in supposition the functions of all modules, whether or not anything calls them.
void check_functions(Session& session);

/// Settings that no param has taken.
void report_unused_settings(Session& session);

}  // namespace toile
