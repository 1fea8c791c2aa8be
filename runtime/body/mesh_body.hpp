// A body that is a surface of triangles: exact signed distances to it.
#pragma once

#include <memory>

#include "runtime/body/form.hpp"

namespace toile {

/// The surface must be closed, 2-manifold and face outwards.
std::shared_ptr<const Body> make_mesh_body(BodySpec spec, LinedSurface lined);

}  // namespace toile
