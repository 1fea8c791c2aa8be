// Whether triangles are the closed surface of a solid.
#pragma once

#include <string>

#include "runtime/body/body.hpp"

namespace toile {

/// Empty when the surface is closed, 2-manifold, consistently oriented and without degenerate triangles; otherwise
/// what is wrong, in words.
std::string manifold_fault(const Body::Surface& surface);

/// The enclosed volume [m3], negative when the triangles face inwards.
double signed_volume(const Body::Surface& surface);

/// Makes the triangles face outwards.
void face_outwards(Body::Surface& surface);

}  // namespace toile
