// `arrange`: where pieces stand in space before they are sewn.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Adds to the garment's draft; `garment.sound` is false after a mistake.
void read_arrangement(Session& session, GarmentInstance& garment, const Scope& scope, const syntax::Arrange& arrange);

}  // namespace toile
