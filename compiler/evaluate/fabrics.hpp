// `fabric` and `textile` blocks: a KES sheet as it is printed, and the colours of the threads.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

void define_fabric(Session& session, Scope& scope, const syntax::Fabric& written);
void define_textile(Session& session, Scope& scope, const syntax::Textile& written);

}  // namespace toile
