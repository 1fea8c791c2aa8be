#include "tests/validation/suite/drape_test.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compiler/pattern/draft.hpp"
#include "runtime/drape/carry_over.hpp"
#include "runtime/drape/levels.hpp"
#include "runtime/report/folds.hpp"
#include "tests/validation/suite/shadow.hpp"

namespace toile::validation {
namespace {

constexpr double disc_top = 0.3;  // [m]

Garment round_specimen(double radius, const FabricSheet& fabric) {
  DraftPiece piece;
  piece.name = "round";
  const Curve rim = circle({0, 0}, {radius, 0});
  const double half = rim.length() / 2;
  piece.outline = {{"first", rim.part(0, half), {}}, {"second", rim.part(half, rim.length()), {}}};
  DraftGarment draft;
  draft.name = "specimen";
  draft.pieces = {piece};
  draft.fabric = fabric;
  std::vector<Diagnostic> found;
  return make_garment(draft, found);
}

}  // namespace

DrapeTest::DrapeTest(const FabricSheet& fabric, const Tester& tester)
    : fabric_(fabric), tester_(tester), garment_(round_specimen(tester.specimen, fabric)) {
  BodySpec spec;
  spec.shape = DiscSpec{tester.disc, 0.02, disc_top};
  std::string error;
  body_ = Body::make(spec, &error);
}

SewnMesh DrapeTest::mesh(double edge) const {
  PMeshOptions options;
  options.target_edge = edge;
  return sew(garment_, options);
}

Drape DrapeTest::drape_on(const SewnMesh& mesh, const std::vector<Vec3>& start, bool carried) const {
  DrapeOptions options;
  options.carried_over = carried;
  return drape(make_cloth(mesh), fabric_, body_.get(), {start, {}, {}}, options, {});
}

DrapeFigures DrapeTest::figures(const Drape& drape) const {
  const double disc = std::numbers::pi * tester_.disc * tester_.disc;
  const double all = std::numbers::pi * tester_.specimen * tester_.specimen;
  DrapeFigures figures;
  figures.coefficient = 100 * (shadow_area(make_cloth(mesh_), drape.positions) - disc) / (all - disc);
  const std::vector<bool> held(drape.positions.size(), false);
  if (const auto hem = lowest_free_loop(mesh_.s, drape.positions, held)) {
    std::vector<Vec3> loop;
    for (const int vertex : *hem) loop.push_back(drape.positions[static_cast<std::size_t>(vertex)]);
    figures.folds = count_folds(loop);
  }
  figures.energy = drape.energy.total() - drape.energy.friction;
  figures.at_rest = drape.converged;
  return figures;
}

DrapeFigures DrapeTest::from_flat(double edge) {
  mesh_ = mesh(edge);
  std::vector<SewnMesh> meshes;
  for (const double each : level_edges(edge, static_cast<int>(mesh_.p.triangles.size()))) meshes.push_back(mesh(each));
  meshes.push_back(mesh_);
  std::vector<Cloth> cloths;
  for (const SewnMesh& each : meshes) cloths.push_back(make_cloth(each));
  std::vector<DrapeLevel> levels;
  for (std::size_t i = 0; i < meshes.size(); ++i) levels.push_back({&meshes[i], &cloths[i]});
  const DrapedLevels result = drape_levels(levels, {}, {}, {fabric_}, body_.get(), {}, {});
  form_ = result.drape.positions;
  return figures(result.drape);
}

DrapeFigures DrapeTest::carried_to(double edge) {
  SewnMesh finer = mesh(edge);
  const std::vector<Vec3> start = carry_over(mesh_, form_, finer);
  mesh_ = std::move(finer);
  const Drape drape = drape_on(mesh_, start, true);
  form_ = drape.positions;
  return figures(drape);
}

}  // namespace toile::validation
