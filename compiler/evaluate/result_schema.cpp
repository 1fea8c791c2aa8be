// What a drape's result holds, by the names that scripts use: the keys of the report, dotted, without units.
#include "compiler/evaluate/program.hpp"

namespace toile {
namespace {

using Schema = std::vector<std::pair<std::string, std::string>>;

void add(Schema& schema, const std::string& prefix, const std::vector<std::string>& names, const std::string& unit) {
  for (const std::string& name : names) schema.emplace_back(prefix + name, unit);
}

Schema make_schema() {
  Schema schema;
  add(schema, "mesh.", {"triangles", "vertices", "edges", "boundary_loops", "components", "euler", "orientable"}, "1");
  add(schema, "mesh.edge_length.", {"min", "mean", "max"}, "m");
  add(schema, "solve.", {"converged", "iterations", "residual_relative"}, "1");
  add(schema, "solve.", {"residual"}, "N");
  add(schema, "energy.",
      {"stretch_warp", "stretch_weft", "shear", "bend_warp", "bend_weft", "twist", "gravity", "contact", "friction",
       "self_contact", "total"},
      "J");
  add(schema, "contact.", {"weight"}, "N");
  add(schema, "contact.support.", {"body", "friction", "held", "total"}, "N");
  add(schema, "contact.", {"weight_error"}, "%");
  add(schema, "contact.", {"max_penetration"}, "m");
  add(schema, "contact.", {"area"}, "m^2");
  add(schema, "contact.pressure.", {"mean", "p95", "max"}, "Pa");
  add(schema, "self.", {"intersecting_triangle_pairs"}, "1");
  for (const char* direction : {"warp.", "weft."}) {
    add(schema, std::string("strain.") + direction, {"min", "mean", "p95", "max"}, "%");
  }
  add(schema, "strain.shear.", {"min", "mean", "p95", "max"}, "rad");
  for (const char* direction : {"warp.", "weft.", "shear."}) {
    add(schema, std::string("stress.") + direction, {"min", "mean", "p95", "max"}, "N/m");
  }
  add(schema, "", {"area"}, "m^2");
  add(schema, "", {"folds"}, "1");
  add(schema, "hem.", {"length", "low", "high"}, "m");
  add(schema, "bounds.", {"width", "depth", "low", "high"}, "m");
  return schema;
}

Schema make_form_drape_schema() {
  Schema schema = make_schema();
  for (const char* what : {"form.distance.", "form.slip."}) add(schema, what, {"mean", "p95", "max"}, "m");
  return schema;
}

Schema make_development_schema() {
  Schema schema;
  add(schema, "mesh.", {"triangles", "vertices", "edges", "boundary_loops", "components", "euler", "orientable"}, "1");
  add(schema, "solve.", {"converged", "iterations", "flipped", "residual_relative", "drapes"}, "1");
  add(schema, "solve.", {"residual"}, "N");
  add(schema, "energy.", {"stretch_warp", "stretch_weft", "shear", "total"}, "J");
  for (const char* direction : {"warp.", "weft."}) {
    add(schema, std::string("strain.") + direction, {"min", "mean", "p95", "max"}, "%");
  }
  add(schema, "strain.shear.", {"min", "mean", "p95", "max"}, "rad");
  add(schema, "strain.worst.", {"p95"}, "%");
  add(schema, "darts.", {"proposed", "tried"}, "1");
  add(schema, "tried.", {"gain", "p95"}, "%");
  add(schema, "tried.", {"opening"}, "m");
  add(schema, "", {"area", "target_area"}, "m^2");
  add(schema, "seams.", {"mismatch"}, "m");
  return schema;
}

}  // namespace

const std::vector<std::pair<std::string, std::string>>& result_schema() {
  static const Schema schema = make_schema();
  return schema;
}

const std::vector<std::pair<std::string, std::string>>& form_drape_schema() {
  static const Schema schema = make_form_drape_schema();
  return schema;
}

const std::vector<std::pair<std::string, std::string>>& development_schema() {
  static const Schema schema = make_development_schema();
  return schema;
}

}  // namespace toile
