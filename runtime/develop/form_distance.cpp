#include "runtime/develop/form_distance.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/body/triangle_tree.hpp"
#include "runtime/drape/spread.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr double touching = 1e-7;  // [m] nearer than this the way off the form is the form's normal

}  // namespace

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
  std::vector<double> slip_lengths;
  const auto normal_at = [&](int triangle) {
    const std::array<int, 3>& corners = mesh.triangles[index(triangle)];
    const Vec3 a = form[index(corners[0])];
    const Vec3 normal = cross(form[index(corners[1])] - a, form[index(corners[2])] - a);
    return norm(normal) > 0 ? normalized(normal) : Vec3{0, 0, 1};
  };
  for (std::size_t v = 0; v < draped.size(); ++v) {
    const double slip = distance(draped[v], form[v]);
    slip_lengths.push_back(slip);
    found.slips.push_back(draped[v] - form[v]);
    const TriangleTree::Hit hit = surface.nearest(draped[v], slip * (1 + 1e-9) + 1e-9);
    const double apart = hit.triangle < 0 ? slip : std::sqrt(hit.squared);
    const Vec3 off = draped[v] - (hit.triangle < 0 ? form[v] : hit.where.point);
    found.of_vertex.push_back(apart);
    found.across.push_back(apart > touching ? off / apart : normal_at(std::max(hit.triangle, 0)));
  }
  found.distance = spread(found.of_vertex, areas);
  found.slip = spread(slip_lengths, areas);
  return found;
}

}  // namespace toile
