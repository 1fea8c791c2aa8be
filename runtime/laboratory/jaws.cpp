// The jaw is a rigid second triangle at the edge: with theta the angle between both and phi the edge's rotation, the
// cloth's normal is the jaw's where phi = theta.
#include "runtime/laboratory/jaws.hpp"

#include <cmath>
#include <numbers>

namespace toile {
namespace {

using Vector10 = Eigen::Matrix<double, 10, 1>;
using Matrix10 = Eigen::Matrix<double, 10, 10>;

/// The jaw's far point moves with the edge's first.
Eigen::Matrix<double, 9, 1> by_cloth(const Vector12& gradient) {
  Eigen::Matrix<double, 9, 1> folded = gradient.head<9>();
  folded.head<3>() += gradient.tail<3>();
  return folded;
}

Eigen::Matrix<double, 9, 9> by_cloth(const Matrix12& hessian) {
  Eigen::Matrix<double, 9, 12> rows = hessian.topRows<9>();
  rows.topRows<3>() += hessian.bottomRows<3>();
  Eigen::Matrix<double, 9, 9> folded = rows.leftCols<9>();
  folded.leftCols<3>() += rows.rightCols<3>();
  return folded;
}

}  // namespace

int Jaws::hold(const ClothHinge& hinge, int rotation, double length, const Vector3& plane) {
  holds_.push_back({{hinge.vertices[0], hinge.vertices[1], hinge.vertices[2]}, rotation, grip_ * length, plane, 0});
  return static_cast<int>(holds_.size()) - 1;
}

Hinge Jaws::points(const Hold& hold, const Vector& q) {
  const Vector3 first = q.segment<3>(3 * hold.vertices[0]);
  return {first, q.segment<3>(3 * hold.vertices[1]), q.segment<3>(3 * hold.vertices[2]), first + hold.plane};
}

double Jaws::angle(const Hold& hold, const Vector& q) {
  constexpr double turn = 2 * std::numbers::pi;
  const double raw = dihedral(points(hold, q));
  return raw + turn * std::round((hold.last_angle - raw) / turn);
}

double Jaws::moment(int hold, const Vector& q) const {
  const Hold& at = holds_[static_cast<std::size_t>(hold)];
  return at.stiffness * (angle(at, q) - q[at.rotation]);
}

double Jaws::energy(const Vector& q, Vector* gradient) const {
  double energy = 0;
  for (const Hold& hold : holds_) {
    const double lean = q[hold.rotation] - angle(hold, q);
    energy += 0.5 * hold.stiffness * lean * lean;
    if (gradient == nullptr) continue;
    (*gradient)[hold.rotation] += hold.stiffness * lean;
    const auto slope = by_cloth(dihedral_gradient(points(hold, q)));
    for (int k = 0; k < 3; ++k) {
      gradient->segment<3>(3 * hold.vertices[static_cast<std::size_t>(k)]) -=
          hold.stiffness * lean * slope.segment<3>(3 * k);
    }
  }
  return energy;
}

void Jaws::add_hessian(const Vector& q, Curvature curvature, SparseMatrix& matrix) const {
  for (const Hold& hold : holds_) {
    const Hinge at = points(hold, q);
    Vector10 slope;
    slope << -by_cloth(dihedral_gradient(at)), 1;
    Matrix10 hessian = slope * slope.transpose();
    if (curvature == Curvature::Full) {
      hessian.topLeftCorner<9, 9>() -= (q[hold.rotation] - angle(hold, q)) * by_cloth(dihedral_hessian(at));
    }
    std::array<int, 10> unknowns{};
    for (std::size_t k = 0; k < 9; ++k) unknowns[k] = 3 * hold.vertices[k / 3] + static_cast<int>(k % 3);
    unknowns[9] = hold.rotation;
    for (int i = 0; i < 10; ++i) {
      for (int j = 0; j <= i; ++j) {
        matrix.add(unknowns[static_cast<std::size_t>(i)], unknowns[static_cast<std::size_t>(j)],
                   hold.stiffness * hessian(i, j));
      }
    }
  }
}

void Jaws::accept(const Vector& q) {
  for (Hold& hold : holds_) hold.last_angle = angle(hold, q);
}

}  // namespace toile
