// Nodes about the tip of a cone.
#pragma once

#include "compiler/pmesh/triangulate.hpp"

namespace toile {

/// Adds pins about a node of a loop, so that at least `sectors` triangles meet there and as many edges run round it at
/// every distance: on each pair of outline nodes equally many sides away from the tip, where the outline's sides are
/// longer than the sectors are wide. Without them the narrow tip of a cone would close to a double edge, however fine
/// the mesh.
void add_fan(PlaneDomain& domain, int loop, int node, int sectors);

}  // namespace toile
