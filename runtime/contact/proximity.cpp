#include "runtime/contact/proximity.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

Proximity finished(Proximity near, const Quad& x) {
  Vector3 apart = Vector3::Zero();
  for (std::size_t i = 0; i < 4; ++i) apart += near.weights[i] * x[i];
  near.squared = apart.squaredNorm();
  return near;
}

Proximity at_corner(std::size_t corner, const Quad& x) {
  Proximity near;
  near.weights[0] = 1;
  near.weights[corner] = -1;
  return finished(near, x);
}

/// On the side from x[a] to x[b], `t` of the way.
Proximity on_side(std::size_t a, std::size_t b, double t, const Quad& x) {
  Proximity near;
  near.weights[0] = 1;
  near.weights[a] = t - 1;
  near.weights[b] = -t;
  near.freedoms = 1;
  near.slides[0][a] = 1;
  near.slides[0][b] = -1;
  return finished(near, x);
}

}  // namespace

// By the Voronoi regions of the triangle's features (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Proximity corner_to_triangle(const Quad& x) {
  const Vector3 ab = x[2] - x[1], ac = x[3] - x[1];
  const Vector3 ap = x[0] - x[1], bp = x[0] - x[2], cp = x[0] - x[3];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return at_corner(1, x);
  if (d3 >= 0 && d4 <= d3) return at_corner(2, x);
  if (d6 >= 0 && d5 <= d6) return at_corner(3, x);
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return on_side(1, 2, d1 / (d1 - d3), x);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return on_side(1, 3, d2 / (d2 - d6), x);
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return on_side(2, 3, (d4 - d3) / ((d4 - d3) + (d5 - d6)), x);
  const double scale = 1 / (va + vb + vc);
  Proximity near;
  near.weights = {1, vb * scale + vc * scale - 1, -vb * scale, -vc * scale};
  near.freedoms = 2;
  near.slides = {{{0, 1, -1, 0}, {0, 1, 0, -1}}};
  return finished(near, x);
}

// By clamping one parameter after the other (Ericson, 5.1.9).
Proximity edge_to_edge(const Quad& x) {
  const Vector3 d1 = x[1] - x[0], d2 = x[3] - x[2], r = x[0] - x[2];
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), b = d1.dot(d2), c = d1.dot(r), f = d2.dot(r);
  const double parallel = a * e - b * b;
  double s = parallel > 0 ? std::clamp((b * f - c * e) / parallel, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
  }
  Proximity near;
  near.weights = {1 - s, s, t - 1, -t};
  if (s > 0 && s < 1) near.slides[static_cast<std::size_t>(near.freedoms++)] = {-1, 1, 0, 0};
  if (t > 0 && t < 1) near.slides[static_cast<std::size_t>(near.freedoms++)] = {0, 0, 1, -1};
  return finished(near, x);
}

// The nearest points are where the distance does not change with the weights: only the vertices' own motion counts.
Vector12 squared_gradient(const Proximity& near, const Quad& x) {
  Vector3 apart = Vector3::Zero();
  for (std::size_t i = 0; i < 4; ++i) apart += near.weights[i] * x[i];
  Vector12 gradient;
  for (int i = 0; i < 4; ++i) gradient.segment<3>(3 * i) = 2 * near.weights[static_cast<std::size_t>(i)] * apart;
  return gradient;
}

Matrix12 squared_hessian(const Proximity& near, const Quad& x) {
  Vector3 apart = Vector3::Zero();
  std::array<Vector3, 2> slid{Vector3::Zero(), Vector3::Zero()};
  for (std::size_t i = 0; i < 4; ++i) {
    apart += near.weights[i] * x[i];
    for (std::size_t k = 0; k < 2; ++k) slid[k] += near.slides[k][i] * x[i];
  }
  Matrix12 hessian;
  std::array<Vector12, 2> mixed;
  for (int i = 0; i < 4; ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int j = 0; j < 4; ++j) {
      hessian.block<3, 3>(3 * i, 3 * j) =
          2 * near.weights[at] * near.weights[static_cast<std::size_t>(j)] * Matrix3::Identity();
    }
    for (std::size_t k = 0; k < 2; ++k) {
      mixed[k].segment<3>(3 * i) = 2 * (near.slides[k][at] * apart + near.weights[at] * slid[k]);
    }
  }
  // The weights follow the vertices: what they give way by (Schur's complement).
  if (near.freedoms == 1) {
    hessian -= mixed[0] * mixed[0].transpose() / (2 * slid[0].squaredNorm());
  } else if (near.freedoms == 2) {
    const double p = 2 * slid[0].squaredNorm(), q = 2 * slid[0].dot(slid[1]), r = 2 * slid[1].squaredNorm();
    const double det = p * r - q * q;
    const Matrix12 cross = mixed[0] * mixed[1].transpose();
    hessian -=
        (r * mixed[0] * mixed[0].transpose() - q * (cross + cross.transpose()) + p * mixed[1] * mixed[1].transpose()) /
        det;
  }
  return hessian;
}

Skew edge_skew(const Quad& x, bool with_hessian) {
  const Vector3 u = x[1] - x[0], v = x[3] - x[2];
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  Skew skew{.value = uu * vv - uv * uv};
  const Vector3 by_u = 2 * (vv * u - uv * v), by_v = 2 * (uu * v - uv * u);
  skew.gradient << -by_u, by_u, -by_v, by_v;
  if (!with_hessian) return skew;
  const Matrix3 one = Matrix3::Identity();
  const Matrix3 uu_block = 2 * (vv * one - v * v.transpose()), vv_block = 2 * (uu * one - u * u.transpose());
  const Matrix3 uv_block = 2 * (2 * u * v.transpose() - v * u.transpose() - uv * one);
  const std::array<double, 2> sign{-1, 1};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const double same = sign[static_cast<std::size_t>(i)] * sign[static_cast<std::size_t>(j)];
      skew.hessian.block<3, 3>(3 * i, 3 * j) = same * uu_block;
      skew.hessian.block<3, 3>(6 + 3 * i, 6 + 3 * j) = same * vv_block;
      skew.hessian.block<3, 3>(3 * i, 6 + 3 * j) = same * uv_block;
      skew.hessian.block<3, 3>(6 + 3 * j, 3 * i) = same * uv_block.transpose();
    }
  }
  return skew;
}

}  // namespace toile
