// Texts, with values in them, and colours.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

/// `"cut {n} of {width in mm}"`: each value as `print` shows it, or as a number of the unit that is given.
Value written_text(Session& session, const Scope& scope, const syntax::String& written);

/// #rgb or #rrggbb; an alpha has no meaning on cloth and is left out.
Value written_colour(const Session& session, const Module& module, const syntax::Expr& literal);

}  // namespace toile
