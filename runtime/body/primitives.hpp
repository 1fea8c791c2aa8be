// Bodies with exact smooth surfaces: sphere, cylinder, disc, box, plane.
#pragma once

#include <memory>
#include <string>

#include "runtime/body/body.hpp"

namespace toile {

/// `spec.shape` is a SphereSpec, CylinderSpec, DiscSpec, BoxSpec or PlaneSpec; null with `error` when a size is not
/// positive. Edges are rounded: a disc's by half its thickness, a cylinder's and a box's by 2 mm or a quarter of their
/// least extent. Distances are those of the exact solid; the triangles are for pictures, and have their vertices on it.
std::shared_ptr<const Body> make_primitive(const BodySpec& spec, std::string* error);

}  // namespace toile
