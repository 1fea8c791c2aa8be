#include "runtime/develop/length_match.hpp"

#include <algorithm>

namespace toile {
namespace {

constexpr double shortest = 1e-9;  // [m] that derivatives are taken at

/// The length from a to b times `factor`, at rows 4 * side of the eight coordinates.
void add_length(Vec2 a, Vec2 b, double factor, int side, Mismatch& sum) {
  const double length = std::max(norm(b - a), shortest);
  const Eigen::Vector2d along((b.x - a.x) / length, (b.y - a.y) / length);
  const Eigen::Matrix2d across = (Eigen::Matrix2d::Identity() - along * along.transpose()) / length;
  const int row = 4 * side;
  sum.value += factor * length;
  sum.gradient.segment<2>(row) -= factor * along;
  sum.gradient.segment<2>(row + 2) += factor * along;
  for (const int i : {0, 2}) {
    for (const int j : {0, 2}) sum.hessian.block<2, 2>(row + i, row + j) += (i == j ? factor : -factor) * across;
  }
}

}  // namespace

Mismatch mismatch(const LengthMatch& match, const std::array<Vec2, 4>& points) {
  Mismatch sum{0, Vector8::Zero(), Matrix8::Zero()};
  add_length(points[0], points[1], 1, 0, sum);
  add_length(points[2], points[3], -1, 1, sum);
  sum.value -= match.longer;
  return sum;
}

}  // namespace toile
