#include <algorithm>
#include <cmath>
#include <cstddef>

#include "runtime/mesh/index.hpp"

#include "runtime/render/stage.hpp"

namespace toile {
namespace {

template <typename T>
T interpolated(const PerCorner<T>& corner, const RayHit& hit) {
  return (1 - hit.b1 - hit.b2) * corner[0] + hit.b1 * corner[1] + hit.b2 * corner[2];
}

}  // namespace

Spot Stage::spot(const Ray& ray, const RayHit& hit, double pixel) const {
  const Actor& actor = actors_[index(hit.mesh)];
  const Surface& surface = actor.surface;
  const auto& triangle = surface.triangles[index(hit.triangle)];
  const PerCorner<Vec3> corner{surface.points[index(triangle[0])], surface.points[index(triangle[1])],
                               surface.points[index(triangle[2])]};
  Spot spot;
  spot.actor = &actor;
  spot.position = interpolated(corner, hit);
  const Vec3 first = corner[1] - corner[0];
  const Vec3 second = corner[2] - corner[0];
  const Vec3 doubled = cross(first, second);
  const Vec3 flat = norm(doubled) > 0 ? normalized(doubled) : -ray.direction;
  const Vec3 smooth = interpolated(surface.normals[index(hit.triangle)], hit);
  spot.right_side = dot(flat, ray.direction) < 0;
  spot.flat = spot.right_side ? flat : -flat;
  spot.normal = norm(smooth) > 0 ? normalized(smooth) : flat;
  if (!spot.right_side) spot.normal = -spot.normal;
  // Near a silhouette the smooth normal may look away: it is bent back until it is just seen.
  constexpr double kLeast = 0.02;
  const double facing = -dot(spot.normal, ray.direction);
  if (facing < kLeast) spot.normal = normalized(spot.normal + (kLeast - facing) * -ray.direction);

  if (!surface.value.empty()) spot.value = interpolated(surface.value[index(hit.triangle)], hit);
  if (surface.uv.empty()) return spot;
  const Vec3 seams = interpolated(surface.seam[index(hit.triangle)], hit);
  spot.seam = std::min({seams.x, seams.y, seams.z});
  const auto& uv = surface.uv[index(hit.triangle)];
  spot.uv = interpolated(uv, hit);
  // What a pixel covers: its disc, projected along the ray onto the triangle, in barycentrics, then in u and v.
  const double area2 = dot(doubled, doubled);
  if (!(area2 > 0)) return spot;
  const double width = pixel * hit.distance;
  const double steep = std::max(0.1, -dot(spot.flat, ray.direction));
  const Vec3 along = ray.direction - dot(ray.direction, spot.flat) * spot.flat;
  const auto gradient = [&](double du1, double du2) {
    const Vec3 g = (du1 * cross(second, doubled) + du2 * cross(doubled, first)) / area2;
    const double stretched = norm(along) > 0 ? std::abs(dot(g, normalized(along))) * (1 / steep - 1) : 0;
    return width * (norm(g) + stretched);
  };
  spot.footprint = {gradient(uv[1].x - uv[0].x, uv[2].x - uv[0].x), gradient(uv[1].y - uv[0].y, uv[2].y - uv[0].y)};
  return spot;
}

}  // namespace toile
