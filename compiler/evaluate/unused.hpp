// Lets of variations that nothing reads.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Warns of them, once everything is checked.
void report_unused_lets(Session& session);

}  // namespace toile
