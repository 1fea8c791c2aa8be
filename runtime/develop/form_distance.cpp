#include "runtime/develop/form_distance.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/body/triangle_tree.hpp"
#include "runtime/drape/spread.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {

Placed start_on_form(const SMesh& mesh, const std::vector<Wear>& wears, const Target& target, const Body& body,
                     double half_thickness) {
  Placed start;
  start.positions = target.positions;
  for (Vec3& p : start.positions) {
    const auto surface = body.nearest(p, half_thickness);
    if (surface && surface->distance < half_thickness) p += (half_thickness - surface->distance) * surface->normal;
  }
  for (const SMesh::WornLine& line : mesh.worn) {
    if (!wears[index(line.wear)].held) continue;
    start.held.insert(start.held.end(), line.vertices.begin(), line.vertices.end());
  }
  std::sort(start.held.begin(), start.held.end());
  start.held.erase(std::unique(start.held.begin(), start.held.end()), start.held.end());
  return start;
}

FormDistance form_distance(const SMesh& mesh, const std::vector<Vec3>& form, const std::vector<Vec3>& draped,
                           const std::vector<double>& areas) {
  const TriangleTree surface(Body::Surface{form, mesh.triangles});
  FormDistance found;
  std::vector<double> slips;
  for (std::size_t v = 0; v < draped.size(); ++v) {
    const double slip = distance(draped[v], form[v]);
    slips.push_back(slip);
    const TriangleTree::Hit hit = surface.nearest(draped[v], slip * (1 + 1e-9) + 1e-9);
    found.of_vertex.push_back(hit.triangle < 0 ? slip : std::sqrt(hit.squared));
  }
  found.distance = spread(found.of_vertex, areas);
  found.slip = spread(slips, areas);
  return found;
}

}  // namespace toile
