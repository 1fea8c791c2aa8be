// `solve h in 8cm..20cm so length(cap(h)) = armhole + 2cm`: values that make equations hold.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Defines the unknowns. They are sought when the first of them is wanted; until they are found, whatever depends on
/// them is computed anew for each value that is tried.
void define_solve(Session& session, Scope& scope, const syntax::Solve& written);
/// The same for one that is written, and to be read, in another scope.
void define_solve(Session& session, Scope& scope, const Scope& read_in, const syntax::Solve& written);

}  // namespace toile
