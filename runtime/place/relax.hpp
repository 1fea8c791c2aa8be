// Evening out what a start is still strained.
#pragma once

#include <vector>

#include "runtime/body/body.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// Moves free vertices a bounded number of times towards where their edges have their rest lengths; all at once each
/// time, so that no order of numbering shows. With a body, vertices are kept `clearance` outside it, looked after every
/// so many passes.
void relax(const RestMesh& rest, const std::vector<bool>& free, int passes, const Body* body, double clearance,
           std::vector<Vec3>& positions, int passes_between_pushes = 8);

/// Pushes free vertices out of the body until no vertex, middle of an edge or middle of a triangle lies in it, or a
/// bounded number of times. Nothing is pushed where more of the cloth would pass through itself then: the body's
/// contact has gentler ways.
void push_out(const RestMesh& rest, const std::vector<bool>& free, const Body& body, double clearance,
              std::vector<Vec3>& positions);

}  // namespace toile
