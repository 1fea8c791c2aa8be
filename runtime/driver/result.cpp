#include "runtime/driver/result.hpp"

#include <algorithm>

#include "runtime/report/folds.hpp"
#include "runtime/report/summary.hpp"

namespace toile {
namespace {

struct Extent {
  Vec3 low, high;
};

Extent extent(const std::vector<Vec3>& points) {
  Extent all{points.front(), points.front()};
  for (const Vec3& point : points) {
    all.low = {std::min(all.low.x, point.x), std::min(all.low.y, point.y), std::min(all.low.z, point.z)};
    all.high = {std::max(all.high.x, point.x), std::max(all.high.y, point.y), std::max(all.high.z, point.z)};
  }
  return all;
}

void add_energy(Result& result, const Energies& energy) {
  result["energy.stretch_warp"] = energy.stretch_warp;
  result["energy.stretch_weft"] = energy.stretch_weft;
  result["energy.shear"] = energy.shear;
  result["energy.bend_warp"] = energy.bend_warp;
  result["energy.bend_weft"] = energy.bend_weft;
  result["energy.twist"] = energy.twist;
  result["energy.gravity"] = energy.gravity;
  result["energy.contact"] = energy.contact;
  result["energy.friction"] = energy.friction;
  result["energy.self_contact"] = energy.self_contact;
  result["energy.total"] = energy.total();
}

void add_contact(Result& result, const Contact& contact) {
  result["contact.weight"] = contact.weight_N;
  result["contact.support.body"] = contact.support_body_N;
  result["contact.support.friction"] = contact.support_friction_N;
  result["contact.support.held"] = contact.support_held_N;
  result["contact.support.total"] = contact.support_total_N();
  result["contact.weight_error"] = contact.weight_error;
  result["contact.max_penetration"] = contact.max_penetration_m;
  result["contact.area"] = contact.contact_area_m2;
  result["contact.pressure.mean"] = contact.pressure_Pa.mean;
  result["contact.pressure.p95"] = contact.pressure_Pa.p95;
  result["contact.pressure.max"] = contact.pressure_Pa.max;
}

void add_directions(Result& result, const std::string& prefix, const Summary::Directions& directions) {
  const auto add = [&](const char* direction, const Spread& spread) {
    result[prefix + direction + ".min"] = spread.min;
    result[prefix + direction + ".mean"] = spread.mean;
    result[prefix + direction + ".p95"] = spread.p95;
    result[prefix + direction + ".max"] = spread.max;
  };
  add("warp", directions.warp);
  add("weft", directions.weft);
  add("shear", directions.shear);
}

/// The lowest free edge; all zero for a cloth without one.
void add_hem(Result& result, const Draped& draped) {
  std::vector<bool> held(static_cast<std::size_t>(draped.made->cloth.vertex_count), false);
  for (const SMesh::WornLine& line : draped.made->mesh.s.worn) {
    for (const int vertex : line.vertices) held[static_cast<std::size_t>(vertex)] = true;
  }
  double length = 0;
  Extent hem;
  if (const auto loop = lowest_free_loop(draped.made->mesh.s, draped.drape.positions, held)) {
    std::vector<Vec3> points;
    for (const int vertex : *loop) points.push_back(draped.drape.positions[static_cast<std::size_t>(vertex)]);
    for (std::size_t i = 0; i < points.size(); ++i) length += distance(points[i], points[(i + 1) % points.size()]);
    hem = extent(points);
  }
  result["hem.length"] = length;
  result["hem.low"] = hem.low.z;
  result["hem.high"] = hem.high.z;
}

}  // namespace

Result result_of(const Draped& draped) {
  const Summary summary = summarise(draped.view());
  Result result;
  result["mesh.triangles"] = summary.topology.triangles;
  result["mesh.vertices"] = summary.topology.vertices;
  result["mesh.edges"] = summary.topology.edges;
  result["mesh.boundary_loops"] = summary.topology.boundary_loops;
  result["mesh.components"] = summary.topology.components;
  result["mesh.euler"] = summary.topology.euler;
  result["mesh.orientable"] = summary.topology.orientable ? 1 : 0;
  result["mesh.edge_length.min"] = summary.edge_min_m;
  result["mesh.edge_length.mean"] = summary.edge_mean_m;
  result["mesh.edge_length.max"] = summary.edge_max_m;
  result["solve.converged"] = summary.converged ? 1 : 0;
  result["solve.iterations"] = summary.iterations;
  result["solve.residual"] = summary.residual_N;
  result["solve.residual_relative"] = summary.residual_relative;
  add_energy(result, summary.energy_J);
  add_contact(result, summary.contact);
  result["self.intersecting_triangle_pairs"] = summary.intersecting_triangle_pairs;
  add_directions(result, "strain.", summary.strain);
  add_directions(result, "stress.", summary.stress_N_per_m);
  result["area"] = summary.area_m2;
  result["folds"] = summary.folds;
  add_hem(result, draped);
  const Extent bounds = extent(draped.drape.positions);
  result["bounds.width"] = bounds.high.x - bounds.low.x;
  result["bounds.depth"] = bounds.high.y - bounds.low.y;
  result["bounds.low"] = bounds.low.z;
  result["bounds.high"] = bounds.high.z;
  if (draped.form) {
    for (const auto& [name, spread] : {std::pair("distance", draped.form->distance), {"slip", draped.form->slip}}) {
      const std::string prefix = std::string("form.") + name;
      result[prefix + ".mean"] = spread.mean;
      result[prefix + ".p95"] = spread.p95;
      result[prefix + ".max"] = spread.max;
    }
  }
  return result;
}

}  // namespace toile
