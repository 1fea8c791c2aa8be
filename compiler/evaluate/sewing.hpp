// `sew` and `wear`: which edges meet, and which hang on the body.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Add to the garment's draft; `garment.sound` is false after a mistake.
void read_seam(Session& session, GarmentInstance& garment, const Scope& scope, const syntax::Sew& sew);
void read_wear(Session& session, GarmentInstance& garment, const Scope& scope, const syntax::Wear& wear);

}  // namespace toile
