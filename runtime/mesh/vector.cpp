#include "runtime/mesh/vector.hpp"

#include <Eigen/Eigenvalues>

namespace toile {

Spectrum spectrum(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Matrix3 positive_part(const Matrix3& symmetric) {
  Eigen::SelfAdjointEigenSolver<Matrix3> eigen;
  eigen.computeDirect(symmetric);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace toile
