#include <algorithm>

#include "runtime/driver/result.hpp"
#include "runtime/report/summary.hpp"

namespace toile {

Result result_of(const Developed& developed) {
  const Flattened& flat = developed.development.flat;
  const Summary summary = summarise(developed.on_form.view());
  Result result;
  result["mesh.triangles"] = summary.topology.triangles;
  result["mesh.vertices"] = summary.topology.vertices;
  result["mesh.edges"] = summary.topology.edges;
  result["mesh.boundary_loops"] = summary.topology.boundary_loops;
  result["mesh.components"] = summary.topology.components;
  result["mesh.euler"] = summary.topology.euler;
  result["mesh.orientable"] = summary.topology.orientable ? 1 : 0;
  result["solve.converged"] = flat.converged ? 1 : 0;
  result["solve.iterations"] = flat.iterations;
  result["solve.flipped"] = flat.flipped;
  result["solve.drapes"] = developed.drapes;
  result["solve.residual"] = flat.residual_N;
  result["solve.residual_relative"] = flat.residual_relative;
  result["energy.stretch_warp"] = flat.energy.warp;
  result["energy.stretch_weft"] = flat.energy.weft;
  result["energy.shear"] = flat.energy.shear;
  result["energy.total"] = flat.energy.warp + flat.energy.weft + flat.energy.shear;
  const auto add = [&](const std::string& name, const Spread& spread) {
    result["strain." + name + ".min"] = spread.min;
    result["strain." + name + ".mean"] = spread.mean;
    result["strain." + name + ".p95"] = spread.p95;
    result["strain." + name + ".max"] = spread.max;
  };
  add("warp", summary.strain.warp);
  add("weft", summary.strain.weft);
  add("shear", summary.strain.shear);
  const Drape& on_form = developed.on_form.drape;
  std::vector<double> areas;
  for (const ClothTriangle& triangle : developed.on_form.made->cloth.triangles) {
    areas.push_back(0.5 * cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0]));
  }
  result["strain.worst.p95"] = worst_strain_p95(on_form.strain_warp, on_form.strain_weft, on_form.shear_angle, areas);
  result["darts.proposed"] = static_cast<double>(developed.proposed.size());
  result["darts.tried"] = static_cast<double>(developed.tried.size());
  for (const char* name : {"tried.gain", "tried.p95", "tried.opening"}) result[name] = 0;
  for (const TriedDart& dart : developed.tried) {
    const double gain = 1 - dart.with.energy / std::max(dart.without.energy, 1e-300);
    if (&dart != &developed.tried.front() && gain <= result["tried.gain"]) continue;
    result["tried.gain"] = gain;
    result["tried.p95"] = dart.with.p95;
    result["tried.opening"] = dart.opens ? dart.opening : -dart.opening;
  }
  result["area"] = flat.area;
  result["target_area"] = flat.target_area;
  result["seams.mismatch"] = flat.mismatch;
  return result;
}

}  // namespace toile
