#include "runtime/report/report.hpp"

#include <nlohmann/json.hpp>

#include "runtime/develop/darts.hpp"
#include "runtime/develop/grain_study.hpp"
#include "runtime/develop/redraw.hpp"
#include "runtime/export/json_layout.hpp"
#include "runtime/report/summary.hpp"
#include "runtime/report/tightness.hpp"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

Json json(const Spread& spread) {
  return {{"min", spread.min}, {"mean", spread.mean}, {"p95", spread.p95}, {"max", spread.max}};
}

Json json(const Summary::Directions& directions) {
  return {{"warp", json(directions.warp)}, {"weft", json(directions.weft)}, {"shear", json(directions.shear)}};
}

Json mesh(const Summary& summary) {
  const Topology& topology = summary.topology;
  return {{"triangles", topology.triangles},
          {"vertices", topology.vertices},
          {"edges", topology.edges},
          {"boundary_loops", topology.boundary_loops},
          {"components", topology.components},
          {"euler", topology.euler},
          {"orientable", topology.orientable},
          {"manifold", topology.manifold},
          {"area_m2", summary.area_m2},
          {"edge_length_m", {{"min", summary.edge_min_m}, {"mean", summary.edge_mean_m}, {"max", summary.edge_max_m}}}};
}

Json solve(const Summary& summary) {
  const Energies& energy = summary.energy_J;
  return {{"converged", summary.converged},
          {"trouble", summary.trouble},
          {"iterations", summary.iterations},
          {"residual_N", summary.residual_N},
          {"residual_moment_Nm", summary.residual_moment_Nm},
          {"residual_relative", summary.residual_relative},
          {"energy_J",
           {{"stretch_warp", energy.stretch_warp},
            {"stretch_weft", energy.stretch_weft},
            {"shear", energy.shear},
            {"bend_warp", energy.bend_warp},
            {"bend_weft", energy.bend_weft},
            {"twist", energy.twist},
            {"gravity", energy.gravity},
            {"contact", energy.contact},
            {"friction", energy.friction},
            {"self_contact", energy.self_contact},
            {"total", energy.total()}}}};
}

Json tightness(const DrapedGarment& draped) {
  const Tightness tight = tightest(draped);
  return {{"pressure_Pa", tight.pressure_Pa},
          {"piece", tight.piece < 0 ? "" : draped.garment->pieces[static_cast<std::size_t>(tight.piece)].name},
          {"at_m", {tight.at.x, tight.at.y, tight.at.z}},
          {"thread", tight.piece < 0    ? ""
                     : tight.along_warp ? "warp"
                                        : "weft"},
          {"strain", tight.strain},
          {"length_m", tight.length_m},
          {"short_m", tight.short_m}};
}

Json contact(const Contact& contact, const DrapedGarment& draped) {
  return {{"weight_N", contact.weight_N},
          {"support_N",
           {{"body", contact.support_body_N},
            {"friction", contact.support_friction_N},
            {"held", contact.support_held_N},
            {"total", contact.support_total_N()}}},
          {"weight_error", contact.weight_error},
          {"max_penetration_m", contact.max_penetration_m},
          {"contact_area_m2", contact.contact_area_m2},
          {"pressure_Pa",
           {{"mean", contact.pressure_Pa.mean}, {"p95", contact.pressure_Pa.p95}, {"max", contact.pressure_Pa.max}}},
          {"tightest", tightness(draped)}};
}

Json darts(const DrapedGarment& on_form, const Development& development) {
  Json all = Json::array();
  for (std::size_t p = 0; p < on_form.garment->pieces.size(); ++p) {
    const Piece& piece = on_form.garment->pieces[p];
    for (const Dart& dart : piece.darts) {
      const OpenedDart opened = opened_dart(on_form.mesh->p, static_cast<int>(p), dart, development);
      all.push_back({{"piece", piece.name}, {"dart", dart.name}, {"width_m", opened.width}, {"leg_m", opened.leg}});
    }
  }
  return all;
}

/// Null where a dart has a depth instead.
Json tip(const DraftDart& dart) {
  return dart.tip ? Json{dart.tip->x, dart.tip->y} : Json();
}

/// Where on its piece a dart opens, and how deep it goes.
Json place_of(const std::string& piece, const DraftDart& dart) {
  return {{"piece", piece},  {"dart", dart.name},  {"edge", dart.edge},
          {"at_m", dart.at}, {"tip_m", tip(dart)}, {"depth_m", dart.depth}};
}

/// What the piece costs with the dart and without it.
void add_gain(Json& row, const ResidualStrain& with, const ResidualStrain& without) {
  row["energy_J"] = {{"with", with.energy}, {"without", without.energy}};
  row["strain_p95"] = {{"with", with.p95}, {"without", without.p95}};
}

Json json(const std::vector<ProposedDart>& proposed) {
  Json all = Json::array();
  for (const ProposedDart& each : proposed) {
    Json row = place_of(each.piece, each.dart);
    row["without_energy_J"] = each.without.energy;
    row["without_strain_p95"] = each.without.p95;
    all.push_back(std::move(row));
  }
  return all;
}

Json without_each(const std::vector<ProposedDart>& darts) {
  Json all = Json::array();
  for (const ProposedDart& each : darts) {
    Json row = {{"piece", each.piece}, {"dart", each.dart.name}};
    add_gain(row, each.with, each.without);
    all.push_back(std::move(row));
  }
  return all;
}

Json json(const std::vector<TriedDart>& tried) {
  Json all = Json::array();
  for (const TriedDart& each : tried) {
    Json row = place_of(each.piece, each.dart);
    row["opens"] = each.opens;
    row["width_m"] = each.opening;
    add_gain(row, each.with, each.without);
    all.push_back(std::move(row));
  }
  return all;
}

/// A row a turn of the grain.
Json json(const GrainStudy& study) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < GrainStudy::turns.size(); ++i) {
    Json energies = Json::object();
    for (std::size_t j = 0; j < GrainStudy::turns.size(); ++j) {
      energies["developed_for_" + std::to_string(static_cast<int>(GrainStudy::turns[j]))] = study.energy[i][j];
    }
    rows.push_back({{"grain_turned_deg", GrainStudy::turns[i]},
                    {"energy_J_of_the_pattern", energies},
                    {"its_own_pattern_apart_m", study.apart[i]}});
  }
  return rows;
}

std::string text(const Json& root) {
  return laid_out(root.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

std::string report_json(const std::string& script, const DrapedGarment& draped) {
  const Summary summary = summarise(draped);
  return text({{"schema", 1},
               {"script", script},
               {"garment", draped.garment->name},
               {"mesh", mesh(summary)},
               {"solve", solve(summary)},
               {"contact", contact(summary.contact, draped)},
               {"self", {{"intersecting_triangle_pairs", summary.intersecting_triangle_pairs}}},
               {"shape", {{"folds", summary.folds}, {"projected_area_m2", summary.projected_area_m2}}},
               {"strain", json(summary.strain)},
               {"stress_N_per_m", json(summary.stress_N_per_m)}});
}

std::string report_json(const std::string& script, const DrapedGarment& on_form, const Development& development,
                        const Redrawn& redrawn, const DartStudy& study, const GrainStudy& grain) {
  const Summary summary = summarise(on_form);
  const Flattened& flat = development.flat;
  return text({{"schema", 1},
               {"script", script},
               {"garment", on_form.garment->name},
               {"mesh", mesh(summary)},
               {"solve",
                {{"converged", flat.converged},
                 {"iterations", flat.iterations},
                 {"residual_N", flat.residual_N},
                 {"residual_relative", flat.residual_relative}}},
               {"develop",
                {{"area_2d_m2", flat.area},
                 {"area_3d_m2", flat.target_area},
                 {"energy_J",
                  {{"stretch_warp", flat.energy.warp},
                   {"stretch_weft", flat.energy.weft},
                   {"shear", flat.energy.shear},
                   {"total", flat.energy.warp + flat.energy.weft + flat.energy.shear}}},
                 {"residual_strain", json(summary.strain)},
                 {"flipped_triangles", flat.flipped},
                 {"seam_mismatch_m", flat.mismatch},
                 {"outline_error_m", redrawn.error},
                 {"darts", darts(on_form, development)},
                 {"without_each_dart", without_each(study.drawn)},
                 {"darts_proposed", json(study.proposed)},
                 {"darts_tried", json(study.tried)},
                 {"grain", json(grain)}}}});
}

std::string profile_json(const Profile& profile) {
  return text({{"schema", 1},
               {"seconds",
                {{"compile", profile.compile_s},
                 {"mesh", profile.mesh_s},
                 {"place", profile.place_s},
                 {"solve", profile.solve_s},
                 {"total", profile.total_s}}},
               {"cpu_seconds", profile.cpu_s},
               {"peak_memory_bytes", profile.peak_memory_bytes},
               {"factorisations", profile.factorisations}});
}

}  // namespace toile
