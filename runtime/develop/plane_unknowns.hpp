// The plane coordinates of a pattern as the unknowns of a sparse system: two a point, (warp, weft).
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/develop/flatten.hpp"
#include "runtime/solve/sparse.hpp"

namespace toile {

std::vector<int> plane_unknowns(const std::array<int, 3>& triangle);
/// Sides that meet at the tip of a dart share a point: each unknown once.
std::vector<int> plane_unknowns(const LengthMatch& match);
/// All but those that hold the grain, numbered for SparseMatrix.
std::vector<int> free_plane_unknowns(const FlatteningInput& input);
/// The same, numbered so that the factor is sparse as it comes (Cholesky::analyse_in_order): by the points' own graph,
/// which has half as many rows.
std::vector<int> well_ordered_plane_unknowns(const FlatteningInput& input);
/// What the triangles and, after them, the matches couple.
std::vector<std::vector<int>> plane_elements(const FlatteningInput& input);

std::array<int, 4> points_of(const LengthMatch& match);
/// Adds a match's second derivatives; `places` are those of its plane_unknowns().
void add_match(const LengthMatch& match, const Matrix8& hessian, const std::vector<std::int32_t>& places,
               SparseMatrix& matrix);

}  // namespace toile
