#include "runtime/develop/flattening.hpp"

#include <cmath>

namespace toile {
namespace {

using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;
using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

constexpr int most_sweeps = 12;
constexpr int most_turns = 4;  // of Rayleigh's iteration, which triples the digits each time

double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Matrix2 plane_sides(const PlaneCorners& uv) {
  const Vec2 first = uv[1] - uv[0], second = uv[2] - uv[0];
  Matrix2 sides;
  sides << first.x, second.x, first.y, second.y;
  return sides;
}

/// The state of a triangle: what is to be known of the columns of F = X U^-1.
struct FlatState {
  double area;                             // in the plane
  double warp_length, weft_length, angle;  // |fu|, |fv|, phi
  double along, across;                    // fu . fv, fu x fv
};

FlatState flat_state(const TargetTriangle& target, const PlaneCorners& uv) {
  const Matrix2 plane = plane_sides(uv);
  FlatState s;
  s.area = 0.5 * plane.determinant();
  const Matrix2 f = target.sides * plane.inverse();
  s.warp_length = f.col(0).norm();
  s.weft_length = f.col(1).norm();
  s.along = f.col(0).dot(f.col(1));
  s.across = cross(f.col(0), f.col(1));
  s.angle = std::atan2(s.along, s.across);
  return s;
}

struct Densities {
  Density warp, weft, shear;
  double energy() const { return warp.energy + weft.energy + shear.energy; }
};
Densities densities(const FabricLaw& law, const FlatState& s) {
  return {law.warp(s.warp_length - 1), law.weft(s.weft_length - 1), law.shear(s.angle)};
}

// Derivatives are taken by K, the gradient of a small displacement in the plane: K = dU U^-1, entries uu, uv, vu, vv.
// Then dF = -F K, d2F = 2 F K K, dA = A tr K and d2A = 2 A det K. The lengths of the threads, a and b, and phi change
// by -(a, 0, along / a, 0), -(0, along / b, 0, b) and -(0, across / b^2, across / a^2, 0).
constexpr int entries = 4;

Vector4 slope_by_displacement(const FlatState& s, const Densities& psi) {
  const double a = s.warp_length, b = s.weft_length;
  return {psi.energy() - a * psi.warp.force, -s.along / b * psi.weft.force - s.across / (b * b) * psi.shear.force,
          -s.along / a * psi.warp.force - s.across / (a * a) * psi.shear.force, psi.energy() - b * psi.weft.force};
}

/// The terms of the threads' second derivatives that those of the area do not cancel.
Matrix4 hessian_by_displacement(const FlatState& s, const Densities& psi) {
  const double a = s.warp_length, b = s.weft_length, a2 = a * a, b2 = b * b;
  const double turn_warp = s.across / a2, turn_weft = s.across / b2, force = psi.shear.force;
  const double tension = a * psi.warp.force + b * psi.weft.force - psi.energy();
  const auto aside = [&](const Density& thread, double length, double turned) {
    const double slanted = s.along / length;
    return thread.stiffness * slanted * slanted + psi.shear.stiffness * turned * turned +
           thread.force * length * turned * turned - 2 * force * slanted / length * turned;
  };
  Matrix4 h = Matrix4::Zero();
  h(0, 0) = psi.warp.stiffness * a2;
  h(3, 3) = psi.weft.stiffness * b2;
  h(1, 1) = aside(psi.weft, b, turn_weft);
  h(2, 2) = aside(psi.warp, a, turn_warp);
  h(0, 2) = h(2, 0) = psi.warp.stiffness * s.along - turn_warp * force;
  h(1, 3) = h(3, 1) = psi.weft.stiffness * s.along - turn_weft * force;
  h(0, 3) = h(3, 0) = -tension;
  h(1, 2) = h(2, 1) = psi.shear.stiffness * turn_warp * turn_weft + tension;
  return s.area * h;
}

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
  double value = v.dot(symmetric * v);
  for (int round = 0; round < most_turns; ++round) {
    const Vector4 next = (symmetric - value * Matrix4::Identity()).inverse() * v;
    const double length = next.norm();
    if (!std::isfinite(length) || !(length > 0)) break;
    v = next / length;
    value = v.dot(symmetric * v);
  }
  const bool found = (symmetric * v - value * v).norm() < 1e-9 * symmetric.norm();
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

MembraneStrain flattening_strain(const TargetTriangle& target, const PlaneCorners& uv) {
  const FlatState s = flat_state(target, uv);
  return {s.warp_length - 1, s.weft_length - 1, s.angle};
}

MembraneEnergy flattening_energy(const FabricLaw& law, const TargetTriangle& target, const PlaneCorners& uv,
                                 Vector6* gradient) {
  const FlatState s = flat_state(target, uv);
  const Densities psi = densities(law, s);
  if (gradient != nullptr) {
    const Vector4 slope = s.area * slope_by_displacement(s, psi);
    const MembraneShape shape = membrane_shape(uv);
    for (int i = 0; i < 3; ++i) {
      const double du = shape.du[static_cast<std::size_t>(i)], dv = shape.dv[static_cast<std::size_t>(i)];
      (*gradient)[2 * i] = du * slope[0] + dv * slope[1];
      (*gradient)[2 * i + 1] = du * slope[2] + dv * slope[3];
    }
  }
  return {s.area * psi.warp.energy, s.area * psi.weft.energy, s.area * psi.shear.energy};
}

Matrix6 flattening_hessian(const FabricLaw& law, const TargetTriangle& target, const PlaneCorners& uv,
                           Curvature curvature) {
  const FlatState s = flat_state(target, uv);
  Matrix4 by_displacement = hessian_by_displacement(s, densities(law, s));
  if (curvature == Curvature::PositiveDefinite) by_displacement = definite_part(by_displacement);
  // A corner's two coordinates change K by the gradient of its shape function: u the first row of K, v the second.
  const MembraneShape shape = membrane_shape(uv);
  Eigen::Matrix<double, entries, 6> by_corners;
  for (int i = 0; i < 3; ++i) {
    const double du = shape.du[static_cast<std::size_t>(i)], dv = shape.dv[static_cast<std::size_t>(i)];
    by_corners.col(2 * i) = du * by_displacement.col(0) + dv * by_displacement.col(1);
    by_corners.col(2 * i + 1) = du * by_displacement.col(2) + dv * by_displacement.col(3);
  }
  Matrix6 hessian;
  for (int i = 0; i < 3; ++i) {
    const double du = shape.du[static_cast<std::size_t>(i)], dv = shape.dv[static_cast<std::size_t>(i)];
    hessian.row(2 * i) = du * by_corners.row(0) + dv * by_corners.row(1);
    hessian.row(2 * i + 1) = du * by_corners.row(2) + dv * by_corners.row(3);
  }
  return hessian;
}

}  // namespace toile
