#include "runtime/report/summary.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "runtime/contact/self_intersections.hpp"
#include "runtime/drape/spread.hpp"
#include "runtime/field/field.hpp"
#include "runtime/mesh/index.hpp"
#include "runtime/report/folds.hpp"
#include "runtime/report/projection.hpp"

namespace toile {

namespace {

/// The length of an edge in the pattern: the mean of its sides', which differ where fullness is sewn in.
double rest_length(const SMesh::Edge& edge, const Cloth& cloth) {
  double sum = 0;
  for (const SMesh::Wing& wing : edge.wings) {
    const auto& uv = cloth.triangles[index(wing.triangle)].uv;
    sum += distance(uv[index((wing.corner + 1) % 3)], uv[index((wing.corner + 2) % 3)]);
  }
  return edge.wings.empty() ? 0 : sum / static_cast<double>(edge.wings.size());
}

void measure_edges(const Cloth& cloth, Summary& summary) {
  if (cloth.edges.empty()) return;
  double sum = 0;
  summary.edge_min_m = rest_length(cloth.edges.front(), cloth);
  for (const SMesh::Edge& edge : cloth.edges) {
    const double length = rest_length(edge, cloth);
    summary.edge_min_m = std::min(summary.edge_min_m, length);
    summary.edge_max_m = std::max(summary.edge_max_m, length);
    sum += length;
  }
  summary.edge_mean_m = sum / static_cast<double>(cloth.edges.size());
}

std::vector<double> areas_of(const Cloth& cloth) {
  std::vector<double> areas;
  areas.reserve(cloth.triangles.size());
  for (const ClothTriangle& triangle : cloth.triangles) {
    areas.push_back(0.5 * std::abs(cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0])));
  }
  return areas;
}

Summary::Directions directions(const std::string& quantity, const DrapedGarment& draped) {
  const std::vector<double> areas = areas_of(*draped.cloth);
  const auto of = [&](const char* direction) {
    return spread(field(quantity + direction, *draped.cloth, *draped.drape).values, areas);
  };
  return {of(".warp"), of(".weft"), of(".shear")};
}

std::vector<bool> held_vertices(const DrapedGarment& draped) {
  std::vector<bool> held(index(draped.mesh->s.vertex_count), false);
  for (const SMesh::WornLine& worn : draped.mesh->s.worn) {
    if (!draped.garment->wears[index(worn.wear)].held) continue;
    for (const int vertex : worn.vertices) held[index(vertex)] = true;
  }
  return held;
}

int folds_of(const DrapedGarment& draped) {
  const std::vector<Vec3>& positions = draped.drape->positions;
  const auto loop = lowest_free_loop(draped.mesh->s, positions, held_vertices(draped));
  if (!loop) return 0;
  std::vector<Vec3> points;
  points.reserve(loop->size());
  for (const int vertex : *loop) points.push_back(positions[index(vertex)]);
  return count_folds(points);
}

}  // namespace

Summary summarise(const DrapedGarment& draped) {
  const Cloth& cloth = *draped.cloth;
  const Drape& drape = *draped.drape;
  Summary summary;
  summary.topology = draped.mesh->s.topology;
  summary.area_m2 = cloth.area;
  measure_edges(cloth, summary);
  summary.converged = drape.converged;
  summary.trouble = drape.trouble;
  summary.iterations = drape.iterations;
  summary.residual_N = drape.residual_N;
  summary.residual_moment_Nm = drape.residual_moment_Nm;
  summary.residual_relative = drape.residual_relative;
  summary.energy_J = drape.energy;
  summary.contact = drape.contact;
  summary.intersecting_triangle_pairs = intersecting_triangle_pairs(cloth, drape.positions);
  summary.folds = folds_of(draped);
  summary.projected_area_m2 = projected_area(cloth, drape.positions);
  summary.strain = directions("strain", draped);
  summary.stress_N_per_m = directions("stress", draped);
  return summary;
}

}  // namespace toile
