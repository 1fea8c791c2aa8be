#include "runtime/develop/flattening.hpp"

#include <cmath>

namespace toile {
namespace {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

constexpr int entries = 4;  // of the gradient of a displacement in the plane
constexpr int most_sweeps = 12;
constexpr int most_turns = 4;              // of Rayleigh's iteration, which triples the digits each time
constexpr double eigenvalue_error = 1e-9;  // of the largest one

/// Whether Cholesky's factor of a symmetric matrix exists.
bool is_definite(const Matrix4& symmetric) {
  Matrix4 rest = symmetric;
  for (int k = 0; k < entries; ++k) {
    if (!(rest(k, k) > 0)) return false;
    for (int i = k + 1; i < entries; ++i) {
      const double factor = rest(i, k) / rest(k, k);
      for (int j = k + 1; j <= i; ++j) rest(i, j) -= factor * rest(j, k);
    }
  }
  return true;
}

/// Without its one negative eigenvalue, where it has no more: nearly always that of a turn of the triangle in the
/// plane, found by Rayleigh's iteration from there.
std::optional<Matrix4> without_turn(const Matrix4& symmetric) {
  Vector4 v = Vector4(0, 1, -1, 0) * std::sqrt(0.5);
  const double error = eigenvalue_error * symmetric.norm();
  double value = 0;
  bool found = false;
  for (int turn = 0; turn <= most_turns; ++turn) {
    const Vector4 image = symmetric * v;
    value = v.dot(image);
    found = (image - value * v).norm() < error;
    if (found || turn == most_turns) break;
    const Vector4 next = (symmetric - value * Matrix4::Identity()).inverse() * v;
    const double length = next.norm();
    if (!std::isfinite(length) || !(length > 0)) break;
    v = next / length;
  }
  if (!found || value >= 0 || !is_definite(symmetric - 2 * value * v * v.transpose())) return std::nullopt;
  return symmetric - value * v * v.transpose();
}

/// One sweep of Jacobi's rotations; true when there was nothing left to turn.
bool diagonalise(Matrix4& values, Matrix4& vectors) {
  const double least = 1e-15 * values.diagonal().cwiseAbs().maxCoeff();
  bool done = true;
  for (int p = 0; p < entries; ++p) {
    for (int q = p + 1; q < entries; ++q) {
      if (!(std::abs(values(p, q)) > least)) continue;
      done = false;
      const double cotangent = (values(q, q) - values(p, p)) / (2 * values(p, q));
      const double t = std::copysign(1 / (std::abs(cotangent) + std::sqrt(1 + cotangent * cotangent)), cotangent);
      const double c = 1 / std::sqrt(1 + t * t), s = t * c;
      for (int k = 0; k < entries; ++k) {
        const double first = values(k, p), second = values(k, q);
        values(k, p) = c * first - s * second;
        values(k, q) = s * first + c * second;
      }
      for (int k = 0; k < entries; ++k) {
        const double first = values(p, k), second = values(q, k);
        values(p, k) = c * first - s * second;
        values(q, k) = s * first + c * second;
        const double of_first = vectors(k, p), of_second = vectors(k, q);
        vectors(k, p) = c * of_first - s * of_second;
        vectors(k, q) = s * of_first + c * of_second;
      }
    }
  }
  return done;
}

Matrix4 definite_part(const Matrix4& symmetric) {
  if (is_definite(symmetric)) return symmetric;
  if (const auto found = without_turn(symmetric)) return *found;
  Matrix4 values = symmetric, vectors = Matrix4::Identity();
  for (int sweep = 0; sweep < most_sweeps && !diagonalise(values, vectors); ++sweep) {
  }
  Matrix4 part = Matrix4::Zero();
  for (int k = 0; k < entries; ++k) {
    const Vector4 v = vectors.col(k);
    if (values(k, k) > 0) part += values(k, k) * v * v.transpose();
  }
  return part;
}

}  // namespace

std::optional<TargetTriangle> target_triangle(const std::array<Vec3, 3>& corners) {
  const Vec3 first = corners[1] - corners[0], second = corners[2] - corners[0];
  const double length = norm(first), twice_area = norm(toile::cross(first, second));
  if (!(twice_area > 1e-300) || !(length > 0)) return std::nullopt;
  TargetTriangle target;
  target.sides << length, dot(first, second) / length, 0, twice_area / length;
  target.area = 0.5 * twice_area;
  return target;
}

FlatTriangle::FlatTriangle(const FabricLaw& law, const TargetTriangle& target, const PlaneCorners& uv) {
  const Vec2 first = uv[1] - uv[0], second = uv[2] - uv[0];
  const double twice_area = cross(first, second);
  area_ = 0.5 * twice_area;
  by_u_[1] = second.y / twice_area;
  by_u_[2] = -first.y / twice_area;
  by_v_[1] = -second.x / twice_area;
  by_v_[2] = first.x / twice_area;
  by_u_[0] = -(by_u_[1] + by_u_[2]);
  by_v_[0] = -(by_v_[1] + by_v_[2]);
  const auto& sides = target.sides;
  const Vec2 fu{sides(0, 0) * by_u_[1] + sides(0, 1) * by_u_[2], sides(1, 1) * by_u_[2]};
  const Vec2 fv{sides(0, 0) * by_v_[1] + sides(0, 1) * by_v_[2], sides(1, 1) * by_v_[2]};
  warp_length_ = std::sqrt(dot(fu, fu));  // nowhere near where squares overflow
  weft_length_ = std::sqrt(dot(fv, fv));
  along_ = dot(fu, fv);
  across_ = cross(fu, fv);
  warp_ = law.warp(warp_length_ - 1);
  weft_ = law.weft(weft_length_ - 1);
  shear_ = law.shear(std::atan2(along_, across_));
}

MembraneStrain FlatTriangle::strain() const {
  return {warp_length_ - 1, weft_length_ - 1, std::atan2(along_, across_)};
}

// Derivatives are taken by K, the gradient of a small displacement in the plane: K = dU U^-1, entries uu, uv, vu, vv.
// Then dF = -F K, d2F = 2 F K K, dA = A tr K and d2A = 2 A det K. The lengths of the threads, a and b, and phi change
// by -(a, 0, along / a, 0), -(0, along / b, 0, b) and -(0, across / b^2, across / a^2, 0). A corner's two coordinates
// change K by the slopes of its shape function: u the first row of K, v the second.

Vector6 FlatTriangle::gradient() const {
  const double a = warp_length_, b = weft_length_, force = across_ * shear_.force;
  const double uu = area_ * (density() - a * warp_.force), vv = area_ * (density() - b * weft_.force);
  const double uv = -area_ * (along_ / b * weft_.force + force / (b * b));
  const double vu = -area_ * (along_ / a * warp_.force + force / (a * a));
  Vector6 gradient;
  for (int i = 0; i < 3; ++i) {
    const double by_u = by_u_[static_cast<std::size_t>(i)], by_v = by_v_[static_cast<std::size_t>(i)];
    gradient[2 * i] = by_u * uu + by_v * uv;
    gradient[2 * i + 1] = by_u * vu + by_v * vv;
  }
  return gradient;
}

/// The terms of the threads' second derivatives that those of the area do not cancel.
Matrix4 FlatTriangle::hessian_by_displacement() const {
  const double a = warp_length_, b = weft_length_, a2 = a * a, b2 = b * b;
  const double turn_warp = across_ / a2, turn_weft = across_ / b2, force = shear_.force;
  const double tension = a * warp_.force + b * weft_.force - density();
  const auto aside = [&](const Density& thread, double length, double turned) {
    const double slanted = along_ / length;
    return thread.stiffness * slanted * slanted + shear_.stiffness * turned * turned +
           thread.force * length * turned * turned - 2 * force * slanted / length * turned;
  };
  Matrix4 h = Matrix4::Zero();
  h(0, 0) = warp_.stiffness * a2;
  h(3, 3) = weft_.stiffness * b2;
  h(1, 1) = aside(weft_, b, turn_weft);
  h(2, 2) = aside(warp_, a, turn_warp);
  h(0, 2) = h(2, 0) = warp_.stiffness * along_ - turn_warp * force;
  h(1, 3) = h(3, 1) = weft_.stiffness * along_ - turn_weft * force;
  h(0, 3) = h(3, 0) = -tension;
  h(1, 2) = h(2, 1) = shear_.stiffness * turn_warp * turn_weft + tension;
  return area_ * h;
}

Matrix6 FlatTriangle::hessian(Curvature curvature) const {
  Matrix4 by_displacement = hessian_by_displacement();
  if (curvature == Curvature::PositiveDefinite) by_displacement = definite_part(by_displacement);
  Eigen::Matrix<double, entries, 6> by_corners;
  for (int i = 0; i < 3; ++i) {
    const double by_u = by_u_[static_cast<std::size_t>(i)], by_v = by_v_[static_cast<std::size_t>(i)];
    by_corners.col(2 * i) = by_u * by_displacement.col(0) + by_v * by_displacement.col(1);
    by_corners.col(2 * i + 1) = by_u * by_displacement.col(2) + by_v * by_displacement.col(3);
  }
  Matrix6 hessian;
  for (int i = 0; i < 3; ++i) {
    const double by_u = by_u_[static_cast<std::size_t>(i)], by_v = by_v_[static_cast<std::size_t>(i)];
    hessian.row(2 * i) = by_u * by_corners.row(0) + by_v * by_corners.row(1);
    hessian.row(2 * i + 1) = by_u * by_corners.row(2) + by_v * by_corners.row(3);
  }
  return hessian;
}

}  // namespace toile
