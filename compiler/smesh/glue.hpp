// Unifies what seams join.
#pragma once

#include "compiler/smesh/smesh.hpp"

namespace toile {

/// The S-mesh of a P-mesh as it is, strict or not; topology and worn lines not yet filled in.
SMesh glue(const PMesh& mesh);

}  // namespace toile
