// Triangles for round shapes.
#pragma once

#include "runtime/body/body.hpp"
#include "runtime/body/round_shape.hpp"

namespace toile {

/// Closed and outward, all vertices on the exact surface.
Body::Surface triangulate(const RoundShape& shape);

/// Two triangles, 100 m square, facing up.
Body::Surface triangulate_plane(double height);

}  // namespace toile
