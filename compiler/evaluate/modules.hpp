// Texts and how they come together: the script, what it imports, and the settings of the command line.
#pragma once

#include <optional>
#include <string>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Parses a text as a module of the session; syntax errors are reported.
Module& add_module(Session& session, const std::string& name, std::string text, bool from_stdlib);

/// Loads what is imported, if that was not done yet, and defines its name.
void define_import(Session& session, Module& importer, const syntax::Import& written);

/// "parts/cuffs.toile" -> "cuffs"
std::string module_stem(const std::string& name);

/// `--set NAME=EXPR` as a module of one expression.
void add_setting(Session& session, const Setting& setting);
/// That expression, when it is one.
std::optional<syntax::Expr> setting_value(const Module& module);

}  // namespace toile
