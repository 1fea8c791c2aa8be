// What the parser stumbled over, in words.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

void report_syntax_errors(Session& session, const Module& module);

}  // namespace toile
