// From a garment that is drawn on a body to its flat pattern.
#include <fmt/format.h>

#include "compiler/pattern/draft.hpp"
#include "runtime/driver/stopwatch.hpp"
#include "runtime/driver/workroom.hpp"
#include "runtime/fabric/law.hpp"

namespace toile {
namespace {

constexpr double outline_tolerance = 0.0002;  // [m] of the redrawn edges

/// What the development leaves in the cloth where it lies on the form, in the words of a drape.
Drape residual_drape(const Developed& developed, const FabricLaw& law) {
  const Flattened& flat = developed.development.flat;
  Drape drape;
  drape.positions = developed.development.target.positions;
  drape.converged = flat.converged;
  drape.iterations = flat.iterations;
  drape.residual_N = flat.residual_N;
  drape.residual_relative = flat.residual_relative;
  drape.energy.stretch_warp = flat.energy.warp;
  drape.energy.stretch_weft = flat.energy.weft;
  drape.energy.shear = flat.energy.shear;
  for (const MembraneStrain& strain : flat.strains) {
    drape.strain_warp.push_back(strain.warp);
    drape.strain_weft.push_back(strain.weft);
    drape.shear_angle.push_back(strain.shear);
    drape.stress_warp.push_back(law.warp(strain.warp).force);
    drape.stress_weft.push_back(law.weft(strain.weft).force);
    drape.stress_shear.push_back(law.shear(strain.shear).force);
  }
  const std::vector<double> none(flat.strains.size(), 0.0);
  drape.curvature_warp = drape.curvature_weft = drape.twist = none;
  drape.pressure.assign(drape.positions.size(), 0.0);
  drape.edge_rotations.assign(developed.drawn->mesh.s.edges.size(), 0.0);
  return drape;
}

}  // namespace

std::optional<Developed> Workroom::develop(const DevelopCommand& command) {
  Developed developed;
  developed.drawn = make(command.garment);
  if (!developed.drawn) return std::nullopt;
  developed.on_form.body = body(command.body, command.written);
  if (!developed.on_form.body) return std::nullopt;
  const Garment& garment = developed.drawn->garment;
  {
    const Stopwatch watch(profile_.solve_s);
    developed.development = toile::develop(garment, developed.drawn->mesh, *developed.on_form.body, {}, job_);
  }
  for (const Target::Trouble& trouble : developed.development.target.troubles) {
    diagnose(at_place(Severity::Error, "E0512", trouble.written, trouble.message, "drawn here", trouble.help));
  }
  if (!developed.development.target.troubles.empty() || interrupted()) return std::nullopt;
  profile_.factorisations += developed.development.flat.factorisations;

  auto flat = std::make_shared<MadeGarment>(*developed.drawn);
  flat->mesh = developed_mesh(developed.drawn->mesh, developed.development);
  flat->cloth = make_cloth(flat->mesh);
  developed.on_form.made = flat;
  developed.on_form.drape = residual_drape(developed, make_law(garment.fabric));
  developed.redrawn = redraw(garment, developed.drawn->mesh, developed.development, outline_tolerance);
  std::vector<Diagnostic> found;
  developed.pattern = make_garment(developed.redrawn.draft, found);
  for (const Diagnostic& diagnostic : found) {
    diagnose(at_place(Severity::Warning, "W0513", command.written,
                      "the developed pattern is not sound: " + diagnostic.message, "developed here", diagnostic.help));
  }
  note_development(command, developed);
  return developed;
}

void Workroom::note_development(const DevelopCommand& command, const Developed& developed) {
  const Flattened& flat = developed.development.flat;
  listener_->noted(fmt::format(
      "{} developed: {} triangles, {} iterations, {} darts, energy {:.3g} J; sides of seams agree to {:.3f} mm, "
      "outlines redrawn to {:.2f} mm",
      developed.drawn->garment.name, flat.strains.size(), flat.iterations,
      [&] {
        std::size_t darts = 0;
        for (const Piece& piece : developed.drawn->garment.pieces) darts += piece.darts.size();
        return darts;
      }(),
      flat.energy.warp + flat.energy.weft + flat.energy.shear, 1000 * flat.mismatch, 1000 * developed.redrawn.error));
  if (flat.converged) return;
  outcome_.unsettled = true;
  diagnose(at_place(Severity::Warning, "W0513", command.written,
                    fmt::format("the development of {} did not come to rest: {:.1e} of the force of a strain is left",
                                developed.drawn->garment.name, flat.residual_relative),
                    "developed here"));
}

}  // namespace toile
