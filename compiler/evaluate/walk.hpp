// Walking an outline: the pen goes from edge to edge.
#pragma once

#include <string>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// The curve of an edge that begins at the pen. `start` is where the whole outline began. Nothing after a mistake.
std::optional<Curve> walk(Session& session, const Scope& scope, const syntax::Edge& edge, Vec2 pen, Vec2 start);

}  // namespace toile
