#include "runtime/energy/membrane.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double least_length = 1e-9;  // shortest |f| and smallest cosine that derivatives are taken at

/// The two threads of a triangle and the frame their shear turns in.
struct Threads {
  Vector3 warp, weft;               // unit vectors along f_u, f_v
  double warp_length, weft_length;  // |f_u|, |f_v|
  double sine, cosine;              // of the shear angle
  Vector3 warp_turn, weft_turn;     // unit; the direction in which each thread's tip increases the angle
  Vector3 normal;                   // unit, across both
};

Threads threads(const MembraneShape& shape, const Corners& x) {
  const Vector3 fu = shape.du[0] * x[0] + shape.du[1] * x[1] + shape.du[2] * x[2];
  const Vector3 fv = shape.dv[0] * x[0] + shape.dv[1] * x[1] + shape.dv[2] * x[2];
  Threads f;
  f.warp_length = std::max(fu.norm(), least_length);
  f.weft_length = std::max(fv.norm(), least_length);
  f.warp = fu / f.warp_length;
  f.weft = fv / f.weft_length;
  f.sine = std::clamp(f.warp.dot(f.weft), -1.0, 1.0);
  f.normal = f.warp.cross(f.weft);
  f.cosine = std::max(f.normal.norm(), least_length);
  f.normal /= f.cosine;
  f.warp_turn = (f.weft - f.sine * f.warp) / f.cosine;
  f.weft_turn = (f.warp - f.sine * f.weft) / f.cosine;
  return f;
}

double shear_angle(const Threads& f) {
  return std::atan2(f.sine, f.cosine);
}

/// Second derivative of an elongation energy by f; its positive-definite part leaves out the geometric term under
/// compression.
Matrix3 elongation_hessian(const Density& density, const Vector3& thread, double length, Curvature curvature) {
  const double geometric = curvature == Curvature::Full ? density.force : std::max(density.force, 0.0);
  const Matrix3 along = thread * thread.transpose();
  return density.stiffness * along + geometric / length * (Matrix3::Identity() - along);
}

/// c (a b^T + b a^T) for unit a, b at right angles; only the part with a positive eigenvalue where asked.
Matrix3 symmetric_pair(double c, const Vector3& a, const Vector3& b, Curvature curvature) {
  if (curvature == Curvature::Full) return c * (a * b.transpose() + b * a.transpose());
  const Vector3 axis = c > 0 ? Vector3(a + b) : Vector3(a - b);
  return std::abs(c) / 2 * axis * axis.transpose();
}

/// The symmetric matrix (p, q; q, r) without its negative eigenvalue.
Eigen::Matrix2d positive_part(double p, double q, double r) {
  const double mean = 0.5 * (p + r), radius = std::hypot(0.5 * (p - r), q);
  const double high = mean + radius, low = mean - radius;
  Eigen::Matrix2d m;
  m << p, q, q, r;
  if (low >= 0) return m;
  if (high <= 0) return Eigen::Matrix2d::Zero();
  return high / (2 * radius) * (m - low * Eigen::Matrix2d::Identity());
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Second derivative of psi_s by (f_u, f_v). With n the normal and t_u, t_v the turns:
/// phi_u = t_u / |f_u|, phi_uu = -(w t_u^T + t_u w^T + tan(phi) n n^T) / |f_u|^2, phi_uv = n n^T / (|f_u| |f_v|
/// cos(phi)).
Matrix6 shear_hessian(const Density& density, const Threads& f, Curvature curvature) {
  Eigen::Matrix<double, 6, 1> gradient;
  gradient << f.warp_turn / f.warp_length, f.weft_turn / f.weft_length;
  Matrix6 hessian = std::max(density.stiffness, curvature == Curvature::Full ? density.stiffness : 0.0) * gradient *
                    gradient.transpose();
  const double uu = 1 / (f.warp_length * f.warp_length), vv = 1 / (f.weft_length * f.weft_length);
  const double force = density.force;
  hessian.topLeftCorner<3, 3>() += symmetric_pair(-force * uu, f.warp, f.warp_turn, curvature);
  hessian.bottomRightCorner<3, 3>() += symmetric_pair(-force * vv, f.weft, f.weft_turn, curvature);
  const double tangent = f.sine / f.cosine;
  Eigen::Matrix2d across;
  across << -force * tangent * uu, force / (f.warp_length * f.weft_length * f.cosine),
      force / (f.warp_length * f.weft_length * f.cosine), -force * tangent * vv;
  if (curvature == Curvature::PositiveDefinite) across = positive_part(across(0, 0), across(0, 1), across(1, 1));
  const Matrix3 nn = f.normal * f.normal.transpose();
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) hessian.block<3, 3>(3 * i, 3 * j) += across(i, j) * nn;
  }
  return hessian;
}

}  // namespace

MembraneShape membrane_shape(const std::array<Vec2, 3>& uv) {
  MembraneShape shape;
  const double twice_area = cross(uv[1] - uv[0], uv[2] - uv[0]);
  shape.area = 0.5 * std::abs(twice_area);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 opposite = uv[(i + 2) % 3] - uv[(i + 1) % 3];
    shape.du[i] = -opposite.y / twice_area;
    shape.dv[i] = opposite.x / twice_area;
  }
  return shape;
}

MembraneStrain membrane_strain(const MembraneShape& shape, const Corners& x) {
  const Threads f = threads(shape, x);
  return {f.warp_length - 1, f.weft_length - 1, shear_angle(f)};
}

MembraneStrain foreseen_strain(const MembraneShape& shape, const Corners& x, const Corners& dx) {
  const Threads f = threads(shape, x);
  const Vector3 warp = shape.du[0] * dx[0] + shape.du[1] * dx[1] + shape.du[2] * dx[2];
  const Vector3 weft = shape.dv[0] * dx[0] + shape.dv[1] * dx[1] + shape.dv[2] * dx[2];
  return {f.warp_length - 1 + f.warp.dot(warp), f.weft_length - 1 + f.weft.dot(weft),
          shear_angle(f) + f.warp_turn.dot(warp) / f.warp_length + f.weft_turn.dot(weft) / f.weft_length};
}

MembraneEnergy membrane_energy(const FabricLaw& law, const MembraneShape& shape, const Corners& x, Vector9* gradient,
                               const ClothMemory* memory) {
  const Threads f = threads(shape, x);
  const Density warp = law.warp(f.warp_length - 1);
  const Density weft = law.weft(f.weft_length - 1);
  const Density shear = density(law.shear, shear_angle(f), memory != nullptr ? &memory->shear : nullptr);
  if (gradient != nullptr) {
    const Vector3 by_fu = warp.force * f.warp + shear.force / f.warp_length * f.warp_turn;
    const Vector3 by_fv = weft.force * f.weft + shear.force / f.weft_length * f.weft_turn;
    for (std::size_t i = 0; i < 3; ++i) {
      gradient->segment<3>(static_cast<Eigen::Index>(3 * i)) = shape.area * (shape.du[i] * by_fu + shape.dv[i] * by_fv);
    }
  }
  return {shape.area * warp.energy, shape.area * weft.energy, shape.area * shear.energy};
}

Matrix9 membrane_hessian(const FabricLaw& law, const MembraneShape& shape, const Corners& x,
                         const MembraneStrain& stressed, Curvature curvature, const ClothMemory* memory) {
  const double* anchor = memory != nullptr ? &memory->shear : nullptr;
  const Threads f = threads(shape, x);
  Density warp = law.warp(f.warp_length - 1), weft = law.weft(f.weft_length - 1);
  Density shear = density(law.shear, shear_angle(f), anchor);
  warp.force = law.warp(stressed.warp).force;
  weft.force = law.weft(stressed.weft).force;
  shear.force = density(law.shear, stressed.shear, anchor).force;
  Matrix6 by_f = shear_hessian(shear, f, curvature);
  by_f.topLeftCorner<3, 3>() += elongation_hessian(warp, f.warp, f.warp_length, curvature);
  by_f.bottomRightCorner<3, 3>() += elongation_hessian(weft, f.weft, f.weft_length, curvature);
  Matrix9 hessian;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double iu = shape.du[static_cast<std::size_t>(i)], iv = shape.dv[static_cast<std::size_t>(i)];
      const double ju = shape.du[static_cast<std::size_t>(j)], jv = shape.dv[static_cast<std::size_t>(j)];
      hessian.block<3, 3>(3 * i, 3 * j) =
          shape.area * (iu * ju * by_f.topLeftCorner<3, 3>() + iu * jv * by_f.topRightCorner<3, 3>() +
                        iv * ju * by_f.bottomLeftCorner<3, 3>() + iv * jv * by_f.bottomRightCorner<3, 3>());
    }
  }
  return hessian;
}

// With D_i the gradient of a corner's shape function, moving corner j along the axis k by a unit makes the area grow by
// D_j(k) of itself, takes D_i(k) D_j from every D_i, and deforms as moving the corner in space along -f_k would.
Matrix96 membrane_by_pattern(const FabricLaw& law, const MembraneShape& shape, const Corners& x) {
  Vector9 gradient;
  membrane_energy(law, shape, x, &gradient);
  const Matrix9 hessian = membrane_hessian(law, shape, x, membrane_strain(shape, x), Curvature::Full);
  Matrix96 mixed;
  for (const int axis : {0, 1}) {
    const std::array<double, 3>& slope = axis == 0 ? shape.du : shape.dv;
    const Vector3 thread = slope[0] * x[0] + slope[1] * x[1] + slope[2] * x[2];
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        mixed.block<3, 1>(3 * i, 2 * j + axis) = slope[static_cast<std::size_t>(j)] * gradient.segment<3>(3 * i) -
                                                 slope[static_cast<std::size_t>(i)] * gradient.segment<3>(3 * j) -
                                                 hessian.block<3, 3>(3 * i, 3 * j) * thread;
      }
    }
  }
  return mixed;
}

}  // namespace toile
