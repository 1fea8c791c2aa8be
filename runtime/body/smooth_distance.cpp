#include "runtime/body/smooth_distance.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

using Feature = ClosestOnTriangle::Feature;
using Rows = std::array<Vec3, 3>;

void add_outer(Rows& m, double factor, Vec3 a, Vec3 b) {
  m[0] += factor * a.x * b;
  m[1] += factor * a.y * b;
  m[2] += factor * a.z * b;
}

void add_identity(Rows& m, double factor) {
  m[0].x += factor;
  m[1].y += factor;
  m[2].z += factor;
}

/// Value, gradient and second derivative of a sum of functions.
struct Jet {
  double value = 0;
  Vec3 gradient;
  Rows hessian{};
};

/// Adds half the second derivative of the squared distance from a triangle, times `factor`.
void add_squared_distance(Rows& m, double factor, const ClosestOnTriangle& where, const std::array<Vec3, 3>& corners,
                          Vec3 normal) {
  if (where.feature == Feature::Face) {
    add_outer(m, factor, normal, normal);
    return;
  }
  add_identity(m, factor);
  if (where.feature == Feature::Corner) return;
  const Vec3 along = normalized(corners[(where.corner + 2) % 3] - corners[(where.corner + 1) % 3]);
  add_outer(m, -factor, along, along);
}

/// Whether most of the surface has body below it for a kernel of that radius.
template <class Facets>
bool is_thick(const Facets& facets, const TriangleTree& tree, double radius) {
  double all = 0, thick = 0;
  for (const auto& facet : facets) {
    all += facet.weight;
    const Vec3 below = (facet.corners[0] + facet.corners[1] + facet.corners[2]) / 3 - 0.6 * radius * facet.normal;
    if (tree.nearest(below, 0.5 * radius).triangle < 0) thick += facet.weight;
  }
  return thick >= 0.8 * all;
}

}  // namespace

SmoothDistance::SmoothDistance(const Body::Surface& surface, const TriangleTree& tree) : tree_(tree) {
  facets_.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const std::array<Vec3, 3> corners{surface.points[a], surface.points[b], surface.points[c]};
    const Vec3 twice = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = norm(twice);
    // A triangle without a direction of its own has none to give.
    facets_.push_back({corners, length > 0 ? twice / length : Vec3{0, 0, 1}, length / 2});
  }
  while (radius_ > 1e-4 && !is_thick(facets_, tree_, radius_)) radius_ /= 2;
  for (Facet& facet : facets_) facet.weight = std::min(facet.weight / (radius_ * radius_), 1.0);
}

Clearance SmoothDistance::at(Vec3 p, double signed_distance) const {
  const double radius = std::max(radius_, 2 * std::abs(signed_distance)), squared_radius = radius * radius;
  Jet sum, weights;
  tree_.within(p, radius, [&](const TriangleTree::Hit& hit) {
    const Facet& facet = facets_[static_cast<std::size_t>(hit.triangle)];
    const double s = dot(facet.normal, p - facet.corners[0]);
    const double rest = 1 - hit.squared / squared_radius;
    const double weight = facet.weight * rest * rest * rest;
    const double slope = -3 * facet.weight * rest * rest / squared_radius;  // by the squared distance
    const double bend = 6 * facet.weight * rest / (squared_radius * squared_radius);
    const Vec3 offset = p - hit.where.point;  // half the squared distance's gradient
    const Vec3 by_place = 2 * slope * offset;
    weights.value += weight;
    weights.gradient += by_place;
    Rows second{};
    add_outer(second, 4 * bend, offset, offset);
    add_squared_distance(second, 2 * slope, hit.where, facet.corners, facet.normal);
    sum.value += weight * s;
    sum.gradient += weight * facet.normal + s * by_place;
    for (std::size_t k = 0; k < 3; ++k) {
      weights.hessian[k] += second[k];
      sum.hessian[k] += s * second[k];
    }
    add_outer(sum.hessian, 1, by_place, facet.normal);
    add_outer(sum.hessian, 1, facet.normal, by_place);
  });
  Clearance result;
  result.distance = sum.value / weights.value;
  result.gradient = (sum.gradient - result.distance * weights.gradient) / weights.value;
  result.hessian = sum.hessian;
  for (std::size_t k = 0; k < 3; ++k) result.hessian[k] += -result.distance * weights.hessian[k];
  add_outer(result.hessian, -1, result.gradient, weights.gradient);
  add_outer(result.hessian, -1, weights.gradient, result.gradient);
  for (Vec3& row : result.hessian) row = row / weights.value;
  return result;
}

}  // namespace toile
