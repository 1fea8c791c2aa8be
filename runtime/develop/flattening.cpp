#include "runtime/develop/flattening.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace toile {
namespace {

using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;
using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Matrix2 plane_sides(const PlaneCorners& uv) {
  const Vec2 first = uv[1] - uv[0], second = uv[2] - uv[0];
  Matrix2 sides;
  sides << first.x, second.x, first.y, second.y;
  return sides;
}

/// The state of a triangle: the columns of F = X U^-1 and what the laws ask of them.
struct FlatState {
  double area;  // in the plane
  Vector2 fu, fv;
  double warp_length, weft_length, angle;  // |fu|, |fv|, phi
};

FlatState flat_state(const TargetTriangle& target, const PlaneCorners& uv) {
  const Matrix2 plane = plane_sides(uv);
  FlatState s;
  s.area = 0.5 * plane.determinant();
  const Matrix2 f = target.sides * plane.inverse();
  s.fu = f.col(0);
  s.fv = f.col(1);
  s.warp_length = s.fu.norm();
  s.weft_length = s.fv.norm();
  s.angle = std::atan2(s.fu.dot(s.fv), cross(s.fu, s.fv));
  return s;
}

// Derivatives are taken by K, the gradient of a small displacement in the plane: K = dU U^-1, entries uu, uv, vu, vv.
// Then dF = -F K, d2F = 2 F K K, dA = A tr K and d2A = 2 A det K.
constexpr int entries = 4;

/// -F K for K with a one at entry k: the changes of fu and fv.
struct Change {
  Vector2 fu = Vector2::Zero(), fv = Vector2::Zero();
};
std::array<Change, entries> first_changes(const FlatState& s) {
  return {{{-s.fu, Vector2::Zero()}, {Vector2::Zero(), -s.fu}, {-s.fv, Vector2::Zero()}, {Vector2::Zero(), -s.fv}}};
}
/// F (E_k E_l + E_l E_k): entry (i, j) times entry (j, m) gives entry (i, m).
Change second_change(const FlatState& s, int k, int l) {
  Change change;
  const auto add = [&](int a, int b) {
    if (a % 2 != b / 2) return;
    const Vector2& thread = a / 2 == 0 ? s.fu : s.fv;
    (b % 2 == 0 ? change.fu : change.fv) += thread;
  };
  add(k, l);
  add(l, k);
  return change;
}

struct Densities {
  Density warp, weft, shear;
  double energy() const { return warp.energy + weft.energy + shear.energy; }
};
Densities densities(const FabricLaw& law, const FlatState& s) {
  return {law.warp(s.warp_length - 1), law.weft(s.weft_length - 1), law.shear(s.angle)};
}

/// First derivatives of |fu|, |fv|, phi by K, a column each.
Eigen::Matrix<double, entries, 3> strain_slopes(const FlatState& s, const std::array<Change, entries>& first) {
  Eigen::Matrix<double, entries, 3> slopes;
  for (int k = 0; k < entries; ++k) {
    const Change& d = first[static_cast<std::size_t>(k)];
    slopes(k, 0) = s.fu.dot(d.fu) / s.warp_length;
    slopes(k, 1) = s.fv.dot(d.fv) / s.weft_length;
    // phi is a right angle less the angle from fu to fv.
    slopes(k, 2) =
        cross(s.fu, d.fu) / (s.warp_length * s.warp_length) - cross(s.fv, d.fv) / (s.weft_length * s.weft_length);
  }
  return slopes;
}

/// Second derivatives of a thread's length and of its angle: along changes k and l, with the second change c.
double length_curvature(const Vector2& f, double length, const Vector2& k, const Vector2& l, const Vector2& c) {
  return (k.dot(l) - f.dot(k) * f.dot(l) / (length * length) + f.dot(c)) / length;
}
double angle_curvature(const Vector2& f, double length, const Vector2& k, const Vector2& l, const Vector2& c) {
  const double square = length * length;
  return cross(f, c) / square - (f.dot(k) * cross(f, l) + f.dot(l) * cross(f, k)) / (square * square);
}

double trace_of(int entry) {
  return entry == 0 || entry == 3 ? 1 : 0;
}
/// Second derivative of the area over the area.
double area_curvature(int k, int l) {
  if ((k == 0 && l == 3) || (k == 3 && l == 0)) return 1;
  if ((k == 1 && l == 2) || (k == 2 && l == 1)) return -1;
  return 0;
}

Matrix4 hessian_by_displacement(const FlatState& s, const Densities& psi) {
  const std::array<Change, entries> first = first_changes(s);
  const Eigen::Matrix<double, entries, 3> slopes = strain_slopes(s, first);
  const Eigen::Vector3d force(psi.warp.force, psi.weft.force, psi.shear.force);
  const Vector4 slope = slopes * force;
  Matrix4 hessian;
  for (int k = 0; k < entries; ++k) {
    for (int l = k; l < entries; ++l) {
      const Change &a = first[static_cast<std::size_t>(k)], &b = first[static_cast<std::size_t>(l)];
      const Change c = second_change(s, k, l);
      const double shear_curvature = angle_curvature(s.fu, s.warp_length, a.fu, b.fu, c.fu) -
                                     angle_curvature(s.fv, s.weft_length, a.fv, b.fv, c.fv);
      const double material = psi.warp.stiffness * slopes(k, 0) * slopes(l, 0) +
                              psi.weft.stiffness * slopes(k, 1) * slopes(l, 1) +
                              psi.shear.stiffness * slopes(k, 2) * slopes(l, 2);
      const double geometric = psi.warp.force * length_curvature(s.fu, s.warp_length, a.fu, b.fu, c.fu) +
                               psi.weft.force * length_curvature(s.fv, s.weft_length, a.fv, b.fv, c.fv) +
                               psi.shear.force * shear_curvature;
      const double sized = area_curvature(k, l) * psi.energy() + trace_of(k) * slope[l] + trace_of(l) * slope[k];
      hessian(k, l) = hessian(l, k) = s.area * (material + geometric + sized);
    }
  }
  return hessian;
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

Matrix4 definite_part(const Matrix4& symmetric) {
  if (is_definite(symmetric)) return symmetric;
  const Eigen::SelfAdjointEigenSolver<Matrix4> solver(symmetric);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() * solver.eigenvectors().transpose();
}

/// K by the six coordinates: the gradients of the corners' shape functions.
Eigen::Matrix<double, entries, 6> displacement_gradient(const PlaneCorners& uv) {
  const MembraneShape shape = membrane_shape(uv);
  Eigen::Matrix<double, entries, 6> b = Eigen::Matrix<double, entries, 6>::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int component = 0; component < 2; ++component) {
      b(2 * component, 2 * i + component) = shape.du[static_cast<std::size_t>(i)];
      b(2 * component + 1, 2 * i + component) = shape.dv[static_cast<std::size_t>(i)];
    }
  }
  return b;
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
    const Eigen::Vector3d force(psi.warp.force, psi.weft.force, psi.shear.force);
    Vector4 by_displacement = strain_slopes(s, first_changes(s)) * force;
    by_displacement[0] += psi.energy();
    by_displacement[3] += psi.energy();
    *gradient = s.area * displacement_gradient(uv).transpose() * by_displacement;
  }
  return {s.area * psi.warp.energy, s.area * psi.weft.energy, s.area * psi.shear.energy};
}

Matrix6 flattening_hessian(const FabricLaw& law, const TargetTriangle& target, const PlaneCorners& uv,
                           Curvature curvature) {
  const FlatState s = flat_state(target, uv);
  Matrix4 by_displacement = hessian_by_displacement(s, densities(law, s));
  if (curvature == Curvature::PositiveDefinite) by_displacement = definite_part(by_displacement);
  const Eigen::Matrix<double, entries, 6> b = displacement_gradient(uv);
  return b.transpose() * by_displacement * b;
}

}  // namespace toile
