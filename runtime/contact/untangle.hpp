// Out of crossings: a cloth that passes through itself is moved until the lines in which it does have shrunk to
// nothing.
#pragma once

#include <functional>
#include <vector>

#include "runtime/mesh/cloth.hpp"
#include "runtime/mesh/vector.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

struct Crossings {
  int pairs = 0;      // of triangles
  double length = 0;  // [m] of the lines in which they cross
  Vector gradient;    // of the length by the coordinates; as long as q, zero beyond them
};
/// After Volino and Magnenat-Thalmann, Resolving Surface Collisions through Intersection Contour Minimization
/// (SIGGRAPH 2006); the gradient is the exact one of the sum of all segments.
Crossings crossings(const Cloth& cloth, const Vector& q);

/// Moves q until nothing crosses, in a bounded number of steps of `longest` [m] at the most. `readily` makes of a force
/// a motion that the cloth is ready for. Returns the pairs that still cross; q is then as at its best.
int untangle(const Cloth& cloth, const std::function<Vector(const Vector& force)>& readily, double longest,
             const Job& job, Vector& q);

/// The vertices within three edges of a crossing.
std::vector<bool> about_crossings(const Cloth& cloth, const Vector& q);

}  // namespace toile
