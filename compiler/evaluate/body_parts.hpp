// The parts between a body's braces: section, limb, line, surface.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Applies the statements to the body: new sections and lines, or changes to those of a body that is varied.
void apply_parts(Session& session, const Scope& scope, const std::vector<syntax::BodyPart>& parts, BodyInstance& body);

}  // namespace toile
