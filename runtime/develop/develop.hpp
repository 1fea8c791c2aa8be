// Development: from pieces drawn on a body to the flat pattern that takes their form with the least energy.
#pragma once

#include <string>
#include <vector>

#include "compiler/pattern/pattern.hpp"
#include "compiler/smesh/smesh.hpp"
#include "runtime/body/body.hpp"
#include "runtime/develop/flatten.hpp"
#include "runtime/develop/target.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

struct Development {
  Target target;
  FlatteningInput plane;     // what was flattened
  Flattened flat;            // none where the target has troubles
  std::vector<Vec2> points;  // of the P-mesh, each piece in its drawing: upright as it was drawn in the chart
  std::vector<Vec2> warp_of_piece;
};

/// `mesh` is that of the garment as drawn in its charts, `target` where it lies in space, without troubles.
Development develop(const Garment& garment, const SewnMesh& mesh, Target target, const FlattenOptions& options,
                    const Job& job);

/// The same with other places of its points, (warp, weft) as in `flat.uv`.
Development with_pattern(const SewnMesh& mesh, const FabricLaw& law, Development development, std::vector<Vec2> uv);

/// How a dart came out.
struct OpenedDart {
  double width = 0;  // [m] between the ends of its legs at the mouth
  double leg = 0;    // [m] along a leg, to the tip
};
OpenedDart opened_dart(const PMesh& mesh, int piece, const Dart& dart, const Development& development);

/// The same mesh with the developed places: what is draped to see whether it takes the form.
SewnMesh developed_mesh(const SewnMesh& mesh, const Development& development);

}  // namespace toile
