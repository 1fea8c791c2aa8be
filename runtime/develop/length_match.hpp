// Two sides of a seam or a dart that are one line in space: pair by pair their pieces must be equally long in the
// plane, or one by so much longer where it is eased onto the other.
#pragma once

#include <array>

#include "compiler/curve/vec2.hpp"
#include "runtime/mesh/vector.hpp"

namespace toile {

/// A side of the first edge against a side of the second: e = k (|first| - |second| - longer)^2 / 2.
struct LengthMatch {
  std::array<int, 2> first{}, second{};  // points of the P-mesh
  double longer = 0;                     // [m]
  double length = 1;                     // [m] in space
  int seam = 0;                          // whose part it is
};

using Vector8 = Eigen::Matrix<double, 8, 1>;
using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// |first| - |second| - longer, and its derivatives by the eight coordinates (first a, first b, second a, second b).
struct Mismatch {
  double value = 0;
  Vector8 gradient;
  Matrix8 hessian;
};
Mismatch mismatch(const LengthMatch& match, const std::array<Vec2, 4>& points);

}  // namespace toile
