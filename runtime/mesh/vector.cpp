#include "runtime/mesh/vector.hpp"

#include <Eigen/Eigenvalues>

namespace toile {

Matrix3 positive_part(const Matrix3& symmetric) {
  Eigen::SelfAdjointEigenSolver<Matrix3> eigen;
  eigen.computeDirect(symmetric);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace toile
