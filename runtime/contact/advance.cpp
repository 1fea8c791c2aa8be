#include "runtime/contact/advance.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double kept = 0.1;  // of the distance
constexpr int most_advances = 200;

double longest(const Quad& step, std::size_t begin, std::size_t end) {
  double longest = 0;
  for (std::size_t i = begin; i < end; ++i) longest = std::max(longest, step[i].squaredNorm());
  return std::sqrt(longest);
}

}  // namespace

Quad places(const Pair& pair, const Vector& q) {
  Quad x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = q.segment<3>(3 * pair.vertices[i]);
  return x;
}

Proximity proximity(Pair::Kind kind, const Quad& x) {
  return kind == Pair::Kind::CornerTriangle ? corner_to_triangle(x) : edge_to_edge(x);
}

double apart(Pair::Kind kind, const Quad& x) {
  // The second point is the edge's other end, or one of the triangle's corners.
  const bool edges = kind == Pair::Kind::EdgeEdge;
  const Eigen::Array3d one = x[0].array(), second = x[1].array();
  const Eigen::Array3d low = edges ? one.min(second).eval() : one, high = edges ? one.max(second).eval() : one;
  const Eigen::Array3d third = x[2].array(), fourth = x[3].array(), other = edges ? third : second;
  const Eigen::Array3d far_low = other.min(third).min(fourth), far_high = other.max(third).max(fourth);
  return (low - far_high).max(far_low - high).maxCoeff();
}

double free_fraction(const Pair& pair, const Vector& q, const Vector& step, double most) {
  Quad move = places(pair, step);
  const Vector3 common = (move[0] + move[1] + move[2] + move[3]) / 4;
  for (Vector3& m : move) m -= common;
  const std::size_t split = pair.kind == Pair::Kind::CornerTriangle ? 1 : 2;
  // No point of the one nears a point of the other faster than this.
  const double speed = longest(move, 0, split) + longest(move, split, 4);
  Quad x = places(pair, q);
  if (speed * most <= (1 - kept) * apart(pair.kind, x)) return most;
  double distance = std::sqrt(proximity(pair.kind, x).squared);
  const double least = kept * distance;
  if (speed * most <= distance - least) return most;
  double gone = 0;
  for (int i = 0; i < most_advances; ++i) {
    const double further = 0.9 * (distance - least) / speed;
    if (gone + further >= most) return most;
    for (std::size_t k = 0; k < 4; ++k) x[k] += further * move[k];
    gone += further;
    distance = std::sqrt(proximity(pair.kind, x).squared);
    if (distance - least < 0.1 * least) break;
  }
  return gone;
}

}  // namespace toile
