// From a garment that is drawn on a body to its flat pattern.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/draft.hpp"
#include "runtime/drape/rest_state.hpp"
#include "runtime/driver/result.hpp"
#include "runtime/driver/stopwatch.hpp"
#include "runtime/driver/workroom.hpp"
#include "runtime/export/pattern_text.hpp"
#include "runtime/fabric/law.hpp"

namespace toile {
namespace {

constexpr double outline_tolerance = 0.0002;  // [m] of the redrawn edges

/// Pieces that cannot be cut are shown all the same, so that it is seen where they overlap.
void show_uncut(const DraftGarment& draft, Garment& pattern) {
  for (const DraftPiece& piece : draft.pieces) {
    const bool is_cut = std::any_of(pattern.pieces.begin(), pattern.pieces.end(),
                                    [&](const Piece& cut) { return cut.drawn_name == piece.name; });
    if (is_cut) continue;
    Piece shown = drawn_piece(piece).piece;
    for (PieceEdge& edge : shown.edges) edge.allowance = 0;
    pattern.pieces.push_back(std::move(shown));
  }
}

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
  developed.draft = program_->drafts()[static_cast<std::size_t>(command.garment)];
  developed.draft.fabric = developed.drawn->garment.fabric;
  if (command.strain && target(*developed.drawn, *developed.on_form.body)) propose_darts(command, developed);
  if (interrupted()) return std::nullopt;
  const Garment& garment = developed.drawn->garment;
  const std::optional<Target> form = target(*developed.drawn, *developed.on_form.body);
  if (!form) return std::nullopt;
  {
    const Stopwatch watch(profile_.solve_s);
    developed.tried = try_darts(developed.draft, *developed.on_form.body, triangles_of_a_piece(developed.draft), job_);
  }
  if (interrupted()) return std::nullopt;
  flatten_to(*form, developed);
  if (command.within && !interrupted()) correct(command, *form, developed);
  if (interrupted()) return std::nullopt;

  developed.redrawn = redraw(garment, developed.drawn->mesh, developed.development, outline_tolerance);
  std::vector<Diagnostic> found;
  developed.pattern = make_garment(developed.redrawn.draft, found);
  for (const Diagnostic& diagnostic : found) {
    diagnose(at_place(Severity::Warning, "W0515", command.written,
                      "the developed pattern cannot be cut as it is: " + diagnostic.message, "developed here",
                      "where the form is a saddle a dart does not open: leave it out, or end it elsewhere"));
  }
  show_uncut(developed.redrawn.draft, developed.pattern);
  note_development(command, developed);
  return developed;
}

int Workroom::triangles_of_a_piece(const DraftGarment& draft) const {
  return options_.triangles / static_cast<int>(std::max<std::size_t>(1, draft.pieces.size()));
}

void Workroom::propose_darts(const DevelopCommand& command, Developed& developed) {
  const DraftGarment& draft = developed.draft;
  DartProposal proposal;
  {
    const Stopwatch watch(profile_.solve_s);
    proposal = toile::propose_darts(draft, *developed.on_form.body, *command.strain, triangles_of_a_piece(draft), job_);
  }
  if (proposal.darts.empty() || interrupted()) return;
  auto made = std::make_shared<MadeGarment>();
  std::vector<Diagnostic> found;
  made->garment = make_garment(proposal.draft, found);
  for (const Diagnostic& diagnostic : found) {
    if (diagnostic.severity == Severity::Error) return diagnose(diagnostic);
  }
  made->mesh_options = developed.drawn->mesh_options;
  made->mesh = sew(made->garment, made->mesh_options);
  made->cloth = make_cloth(made->mesh);
  developed.drawn = made;
  developed.draft = std::move(proposal.draft);
  developed.proposed = std::move(proposal.darts);
}

std::optional<Target> Workroom::target(const MadeGarment& made, const Body& body) {
  Target target = find_target(made.garment, made.mesh, body);
  for (const Target::Trouble& trouble : target.troubles) {
    diagnose(at_place(Severity::Error, "E0512", trouble.written, trouble.message, "drawn here", trouble.help));
  }
  if (!target.troubles.empty()) return std::nullopt;
  return target;
}

std::shared_ptr<const Body> Workroom::body_called(const std::string& name, Location wanted) {
  const std::vector<BodySpec>& bodies = program_->bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].name == name) return body(static_cast<int>(i), wanted);
  }
  return nullptr;
}

void Workroom::lay_on_form(Developed& developed) {
  auto flat = std::make_shared<MadeGarment>(*developed.drawn);
  flat->mesh = developed_mesh(developed.drawn->mesh, developed.development);
  flat->cloth = make_cloth(flat->mesh);
  developed.on_form.made = flat;
  developed.on_form.drape = residual_drape(developed, make_law(developed.drawn->garment.fabric));
}

void Workroom::flatten_to(const Target& target, Developed& developed) {
  const Garment& garment = developed.drawn->garment;
  {
    const Stopwatch watch(profile_.solve_s);
    developed.development = toile::develop(garment, developed.drawn->mesh, target, {}, job_);
  }
  profile_.factorisations += developed.development.flat.factorisations;
  lay_on_form(developed);
}

std::optional<Draped> Workroom::drape_on_form(const DrapeCommand& command, const Developed& developed,
                                              const Target& form, const AtRestOnForm& at_rest) {
  Draped draped;
  draped.made = developed.on_form.made;
  draped.body = developed.on_form.body;
  const MadeGarment& made = *draped.made;
  const Placed start =
      start_on_form(made.mesh.s, made.garment.wears, form, *draped.body, make_law(made.garment.fabric).thickness / 2);
  DrapeOptions options = drape_options(command);
  options.carried_over = true;
  if (at_rest) {
    options.at_rest = [&](const RestState& rest) {
      std::vector<Vec3> positions;
      for (int v = 0; v < made.mesh.s.vertex_count; ++v) positions.push_back(to_vec3(rest.q.segment<3>(3 * v)));
      at_rest(rest, form_distance(made.mesh.s, start.positions, positions, made.cloth.area_of_vertex));
    };
  }
  {
    const Stopwatch watch(profile_.solve_s);
    draped.drape = toile::drape(made.cloth, made.garment.fabric, draped.body.get(), start, options, job_);
  }
  profile_.factorisations += draped.drape.factorisations;
  if (interrupted()) return std::nullopt;
  draped.form = form_distance(made.mesh.s, start.positions, draped.drape.positions, made.cloth.area_of_vertex);
  return draped;
}

std::optional<Draped> Workroom::drape(const DrapeCommand& command, const Developed& developed) {
  std::optional<Draped> draped = drape_on_form(
      command, developed, find_target(developed.drawn->garment, developed.drawn->mesh, *developed.on_form.body), {});
  if (!draped) return std::nullopt;
  note_drape(command, *draped);
  const Spread& distance = draped->form->distance;
  listener_->noted(fmt::format("{} from its form: mean {:.2f} mm, 95 % {:.2f} mm, at most {:.2f} mm",
                               draped->made->garment.name, 1000 * distance.mean, 1000 * distance.p95,
                               1000 * distance.max));
  return draped;
}

void Workroom::note_strain(const DevelopCommand& command, const Developed& developed) {
  const double left = result_of(developed).at("strain.worst.p95");
  listener_->noted(fmt::format("{}: {} darts proposed, 95 % of the cloth strained by {:.2f} % at most",
                               developed.drawn->garment.name, developed.proposed.size(), 100 * left));
  if (left <= *command.strain) return;
  diagnose(at_place(Severity::Warning, "W0517", command.written,
                    fmt::format("darts do not take the strain out of {}: with those proposed 95 % of the cloth are "
                                "strained by {:.2f} % at most, not {:.2f} %",
                                developed.drawn->garment.name, 100 * left, 100 * *command.strain),
                    "developed here", "divide the piece by a seam where the picture of the strain is darkest"));
}

void Workroom::note_tried(const TriedDart& dart) {
  listener_->noted(
      fmt::format("tried in {}: {}; it would {} by {:.1f} mm and leave {:.3g} J of {:.3g} J, 95 % of the "
                  "cloth strained by {:.2f} % at most, not {:.2f} %",
                  dart.piece, slit_text(dart.dart), dart.opens ? "open" : "lap over", 1000 * dart.opening,
                  dart.with.energy, dart.without.energy, 100 * dart.with.p95, 100 * dart.without.p95));
}

void Workroom::note_development(const DevelopCommand& command, const Developed& developed) {
  const Flattened& flat = developed.development.flat;
  listener_->noted(fmt::format(
      "{} developed: {} triangles, {} iterations, darts: {}, energy {:.3g} J; sides of seams agree to {:.3f} mm, "
      "outlines redrawn to {:.2f} mm",
      developed.drawn->garment.name, flat.strains.size(), flat.iterations,
      [&] {
        std::size_t darts = 0;
        for (const Piece& piece : developed.drawn->garment.pieces) darts += piece.darts.size();
        return darts;
      }(),
      flat.energy.warp + flat.energy.weft + flat.energy.shear, 1000 * flat.mismatch, 1000 * developed.redrawn.error));
  for (const ProposedDart& dart : developed.proposed) {
    listener_->noted(fmt::format("proposed for {}: {}; without it {:.3g} J and {:.2f} % would be left", dart.piece,
                                 slit_text(dart.dart), dart.without.energy, 100 * dart.without.p95));
  }
  for (const TriedDart& dart : developed.tried) note_tried(dart);
  if (command.strain) note_strain(command, developed);
  if (flat.converged) return;
  outcome_.unsettled = true;
  diagnose(at_place(Severity::Warning, "W0509", command.written,
                    fmt::format("the development of {} did not come to rest: {:.1e} of the force of a strain is left",
                                developed.drawn->garment.name, flat.residual_relative),
                    "developed here"));
}

}  // namespace toile
