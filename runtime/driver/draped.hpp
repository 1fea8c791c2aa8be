// What a workroom makes of a garment: its meshes, and each of its drapes.
#pragma once

#include <memory>
#include <vector>

#include "compiler/pattern/pattern.hpp"
#include "compiler/smesh/smesh.hpp"
#include "runtime/body/body.hpp"
#include "runtime/develop/darts.hpp"
#include "runtime/develop/form_distance.hpp"
#include "runtime/develop/redraw.hpp"
#include "runtime/drape/drape.hpp"
#include "runtime/export/export.hpp"
#include "runtime/mesh/cloth.hpp"

namespace toile {

/// A garment sewn up, ready to be draped any number of times.
struct MadeGarment {
  Garment garment;
  PMeshOptions mesh_options;
  SewnMesh mesh;
  Cloth cloth;
};

/// A coarser mesh of the same garment.
struct CoarseGarment {
  SewnMesh mesh;
  Cloth cloth;
};

/// A drape with all that pictures, files and reports need of it.
struct Draped {
  std::shared_ptr<const MadeGarment> made;
  std::shared_ptr<const Body> body;  // null where the cloth floats
  Drape drape;
  std::optional<FormDistance> form;  // of a developed pattern: from the form it was developed for

  DrapedGarment view() const { return {&made->garment, &made->mesh, &made->cloth, &drape}; }
};

/// A development: the pattern, and the cloth cut by it as it lies on the form.
struct Developed {
  std::shared_ptr<const MadeGarment> drawn;  // in the charts
  DraftGarment draft;                        // that it was made from
  Development development;
  Redrawn redrawn;
  Garment pattern;                     // as redrawn
  std::vector<ProposedDart> proposed;  // its darts beyond those drawn
  std::vector<TriedDart> tried;        // what each of the darts would do that are drawn, but not cut
  int drapes = 0;                      // that the pattern was corrected by
  Draped on_form;                      // the developed mesh in the places where it was drawn: residual strains
};

}  // namespace toile
