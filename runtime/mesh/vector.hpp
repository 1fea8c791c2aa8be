// Eigen types of the mechanics, internal to the runtime's .cpp files.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "runtime/mesh/vec3.hpp"

namespace toile {

using Vector = Eigen::VectorXd;
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

inline Vector3 to_eigen(Vec3 v) {
  return {v.x, v.y, v.z};
}
inline Vec3 to_vec3(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// A symmetric matrix's eigenvalues, ascending, and beside each its unit eigenvector as a column.
struct Spectrum {
  Vector values;
  Eigen::MatrixXd vectors;
};

/// For matrices of any size. It lives in one place because Eigen's solver takes the compiler five seconds a size.
Spectrum spectrum(const Eigen::MatrixXd& symmetric);

/// The nearest symmetric matrix without negative eigenvalues.
Matrix3 positive_part(const Matrix3& symmetric);

/// Which second derivative an element gives: the true one, or its part that keeps Newton's matrix positive definite.
enum class Curvature { Full, PositiveDefinite };

}  // namespace toile
