// Solids with closed-form distances: a convex core thickened by a radius, so that every edge is rounded.
#pragma once

#include <variant>

#include "runtime/mesh/vec3.hpp"

namespace toile {

struct BoxCore {
  Vec3 half;  // half extents; zero for a point
};
struct CylinderCore {
  double radius = 0;
  double half_length = 0;
  bool upright = true;  // else along x
};

struct RoundShape {
  Vec3 centre;
  std::variant<BoxCore, CylinderCore> core;
  double rounding = 0;  // [m] > 0
};

/// Distance to the solid's surface, negative inside, and the unit direction in which it grows.
struct SignedDistance {
  double distance = 0;
  Vec3 gradient;
};
SignedDistance signed_distance(const RoundShape& shape, Vec3 p);

}  // namespace toile
