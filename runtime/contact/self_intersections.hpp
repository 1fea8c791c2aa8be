// Crossings of the cloth with itself, counted with exact predicates: what a drape must not have at its end.
#pragma once

#include <array>
#include <vector>

#include "runtime/mesh/cloth.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile {

/// Pairs of triangles that share a point of space beyond the vertices they have in common: pairs without
/// a common vertex that touch or cross, and pairs with one common vertex that meet elsewhere too. Neighbours along an
/// edge are not counted. A triangle without area, or with a coordinate that is not finite, counts in no pair.
/// The lower number first, in order. O(n log n) for a cloth that does not crowd.
std::vector<std::array<int, 2>> intersecting_triangles(const Cloth& cloth, const std::vector<Vec3>& positions);

/// How many there are.
int intersecting_triangle_pairs(const Cloth& cloth, const std::vector<Vec3>& positions);

}  // namespace toile
