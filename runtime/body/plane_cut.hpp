// Lines of an imported body: where planes cut its surface.
#pragma once

#include <optional>
#include <vector>

#include "runtime/body/body.hpp"

namespace toile {

/// The closed loops in which a plane cuts a closed surface.
std::vector<std::vector<Vec3>> plane_loops(const Body::Surface& surface, Vec3 point, Vec3 unit_normal);

/// The loop nearest to the plane's point, as a body's line: from its front counter-clockwise seen from where a garment
/// hangs. The axis is the normal, turned downwards; where the plane stands steep (|n_z| < 1/2) it is turned away from
/// the middle of the body. None when the plane misses the surface.
std::optional<BodyLine> cut_line(const Body::Surface& surface, const MeshSpec::Line& line);

}  // namespace toile
