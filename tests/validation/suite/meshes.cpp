#include "tests/validation/suite/meshes.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/pattern/draft.hpp"
#include "compiler/pmesh/pmesh.hpp"

namespace toile::validation {
namespace {

/// As the pieces of garments are meshed.
Specimen meshed_rectangle(double width, double height, double edge, double warp) {
  DraftPiece piece;
  piece.name = "rectangle";
  piece.outline = {{"bottom", line({0, 0}, {width, 0}), {}},
                   {"right", line({width, 0}, {width, height}), {}},
                   {"top", line({width, height}, {0, height}), {}},
                   {"left", line({0, height}, {0, 0}), {}}};
  DraftGarment draft;
  draft.name = "specimen";
  draft.pieces = {piece};
  std::vector<Diagnostic> found;
  const Garment garment = make_garment(draft, found);
  PMeshOptions options;
  options.target_edge = edge;
  const PMesh mesh = make_pmesh(garment, options);
  return {flat_cloth(mesh.points, mesh.triangles, warp), mesh.points};
}

}  // namespace

const char* name(Mesh mesh) {
  constexpr std::array<const char*, 3> names{"one-way mesh", "irregular mesh", "mesh of pieces"};
  return names[static_cast<std::size_t>(mesh)];
}

Specimen sheet(Mesh mesh, double width, double height, double edge, double warp) {
  if (mesh == Mesh::Pieces) return meshed_rectangle(width, height, edge, warp);
  Cutting cutting;
  cutting.columns = std::max(1, static_cast<int>(std::lround(width / edge)));
  cutting.rows = std::max(1, static_cast<int>(std::lround(height / edge)));
  cutting.jitter = mesh == Mesh::Irregular ? 0.25 : 0;
  cutting.alternating = mesh == Mesh::Irregular;
  return rectangle(width, height, cutting, warp);
}

FabricLaw bending_cloth(WarpWeft rigidity, double twist, double weight, double membrane) {
  FabricSheet sheet;
  sheet.b = rigidity;
  sheet.twist = twist;
  sheet.weight = weight;
  sheet.stretch = WarpWeft{membrane, membrane};
  sheet.shear = membrane / 2;
  return make_law(sheet);
}

}  // namespace toile::validation
