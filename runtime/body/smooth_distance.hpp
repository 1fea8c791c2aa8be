// The distance from a faceted surface without the facets' kinks.
#pragma once

#include <vector>

#include "runtime/body/body.hpp"
#include "runtime/body/triangle_tree.hpp"

namespace toile {

/// An implicit moving least squares field of the triangles' planes (after Shen, O'Brien and Shewchuk, Interpolating and
/// Approximating Implicit Surfaces from Polygon Soup, SIGGRAPH 2004): the mean of the signed distances from the planes
/// of all triangles within `radius`, each with a weight that falls to nothing there. Continuous with its gradient,
/// exact on a plane however it is divided, and off the surface of a ball of radius R by about radius^2 / 10 R.
class SmoothDistance {
 public:
  SmoothDistance(const Body::Surface& surface, const TriangleTree& tree);

  /// `signed_distance` [m] is that of p from the triangles themselves; where it is large the field is drawn from
  /// triangles farther away.
  Clearance at(Vec3 p, double signed_distance) const;
  /// [m] How far away a triangle still counts: 5 mm, less where the body is too thin for that.
  double radius() const { return radius_; }

 private:
  struct Facet {
    std::array<Vec3, 3> corners;
    Vec3 normal;
    double weight = 0;
  };
  const TriangleTree& tree_;
  std::vector<Facet> facets_;
  double radius_ = 0.005;
};

}  // namespace toile
