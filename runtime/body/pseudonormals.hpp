// Normals at the faces, edges and corners of a surface, whose sign against the offset tells inside from outside.
#pragma once

#include <array>
#include <vector>

#include "runtime/body/body.hpp"
#include "runtime/body/closest_point.hpp"

namespace toile {

/// Angle-weighted pseudonormals (Bærentzen and Aanæs, IEEE TVCG 11(3), 2005).
class Pseudonormals {
 public:
  explicit Pseudonormals(const Body::Surface& surface);
  /// Unit, outward.
  Vec3 at(int triangle, const ClosestOnTriangle& where) const;

 private:
  struct Normals {
    Vec3 face;
    std::array<Vec3, 3> edge;  // opposite to each corner
    std::array<Vec3, 3> corner;
  };
  std::vector<Normals> of_triangle_;
};

}  // namespace toile
