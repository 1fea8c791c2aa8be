// What the parser stumbled over, in words.
#pragma once

#include "compiler/diag/diagnostic.hpp"
#include "grammar/parse.hpp"

namespace toile {

struct Module;
struct Session;

Diagnostic syntax_diagnostic(const syntax::SyntaxError& error, const Source& source, FileId file);

void report_syntax_errors(Session& session, const Module& module);

}  // namespace toile
