// The point of a triangle nearest to a point.
#pragma once

#include "runtime/mesh/vec3.hpp"

namespace toile {

/// Where on the triangle the nearest point lies: in its inside, on the edge opposite to a corner, or at a corner.
struct ClosestOnTriangle {
  enum class Feature { Face, Edge, Corner } feature = Feature::Face;
  int corner = 0;  // the corner, or the one opposite to the edge
  Vec3 point;
};

/// By the Voronoi regions of the triangle's features (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
inline ClosestOnTriangle closest_on_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  using Feature = ClosestOnTriangle::Feature;
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {Feature::Corner, 0, a};
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {Feature::Corner, 1, b};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {Feature::Edge, 2, a + d1 / (d1 - d3) * ab};
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {Feature::Corner, 2, c};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {Feature::Edge, 1, a + d2 / (d2 - d6) * ac};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return {Feature::Edge, 0, b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)};
  }
  const double scale = 1 / (va + vb + vc);
  return {Feature::Face, 0, a + vb * scale * ab + vc * scale * ac};
}

}  // namespace toile
