// The S-mesh on the body: where each vertex of a garment that is drawn in a chart lies in space.
#pragma once

#include <string>
#include <vector>

#include "compiler/pattern/pattern.hpp"
#include "compiler/smesh/smesh.hpp"
#include "runtime/body/body.hpp"

namespace toile {

struct Target {
  std::vector<Vec3> positions;  // one a vertex of the S-mesh
  std::vector<Vec2> chart;      // one a vertex of the P-mesh: its place in the chart with the slits of darts closed
  struct Trouble {
    std::string message, help;
    Location written;
  };
  std::vector<Trouble> troubles;  // empty when all is well; else positions are not to be used
};

/// Sides that are sewn together must lie on each other on the body, but for the slits of darts, which are closed.
Target find_target(const Garment& garment, const SewnMesh& mesh, const Body& body);

}  // namespace toile
