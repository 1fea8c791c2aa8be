// How near a corner of the cloth is to a triangle, or an edge to an edge, with derivatives of the squared distance.
#pragma once

#include <array>

#include "runtime/mesh/vector.hpp"

namespace toile {

using Quad = std::array<Vector3, 4>;

/// Two primitives' nearest points as weighted sums of four vertices: their difference is sum w_i x_i.
struct Proximity {
  std::array<double, 4> weights{};
  double squared = 0;  // [m2]
  /// Directions in which the nearest points are free to slide, as changes of the weights: two on a face or between two
  /// edges, one on an edge, none at a corner.
  int freedoms = 0;
  std::array<std::array<double, 4>, 2> slides{};
};

/// Of x[0] and the triangle x[1], x[2], x[3].
Proximity corner_to_triangle(const Quad& x);
/// Of the edges x[0] x[1] and x[2] x[3].
Proximity edge_to_edge(const Quad& x);

/// Of the squared distance by the twelve coordinates.
Vector12 squared_gradient(const Proximity& near, const Quad& x);
Matrix12 squared_hessian(const Proximity& near, const Quad& x);

/// |e1 x e2|^2 of the edges x[0] x[1] and x[2] x[3], which vanishes where they are parallel, with its derivatives.
struct Skew {
  double value = 0;  // [m4]
  Vector12 gradient = Vector12::Zero();
  Matrix12 hessian = Matrix12::Zero();
};
Skew edge_skew(const Quad& x, bool with_hessian);

}  // namespace toile
