#include "runtime/body/fairing.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace toile {
namespace {

std::vector<std::vector<int>> neighbours_of(const Body::Surface& surface) {
  std::vector<std::vector<int>> neighbours(surface.points.size());
  for (const auto& t : surface.triangles) {
    for (int c = 0; c < 3; ++c) {
      neighbours[t[c]].push_back(t[(c + 1) % 3]);
      neighbours[t[c]].push_back(t[(c + 2) % 3]);
    }
  }
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

}  // namespace

void fair(Body::Surface& surface, const std::vector<bool>& free) {
  const auto neighbours = neighbours_of(surface);
  const int n = static_cast<int>(surface.points.size());
  std::vector<int> unknown(surface.points.size(), -1);
  int unknowns = 0;
  for (int i = 0; i < n; ++i) {
    if (free[i]) unknown[i] = unknowns++;
  }
  if (unknowns == 0) return;

  // One row an umbrella that a free vertex has a part in: A x = b with the fixed vertices on the right.
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Eigen::RowVector3d> constants;
  for (int i = 0; i < n; ++i) {
    const auto& around = neighbours[i];
    const bool concerned = free[i] || std::any_of(around.begin(), around.end(), [&](int j) { return free[j]; });
    if (!concerned) continue;
    const int row = static_cast<int>(constants.size());
    constants.emplace_back(Eigen::RowVector3d::Zero());
    const auto add = [&](int j, double weight) {
      const Vec3 p = surface.points[j];
      if (free[j])
        entries.emplace_back(row, unknown[j], weight);
      else
        constants.back() -= weight * Eigen::RowVector3d(p.x, p.y, p.z);
    };
    add(i, -1);
    for (const int j : around) add(j, 1.0 / static_cast<double>(around.size()));
  }
  Eigen::SparseMatrix<double> a(static_cast<int>(constants.size()), unknowns);
  a.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixX3d b(static_cast<int>(constants.size()), 3);
  for (int row = 0; row < b.rows(); ++row) b.row(row) = constants[row];

  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(a.transpose() * a);
  if (factor.info() != Eigen::Success) return;
  const Eigen::MatrixX3d x = factor.solve(a.transpose() * b);
  if (!x.allFinite()) return;
  for (int i = 0; i < n; ++i) {
    if (free[i]) surface.points[i] = {x(unknown[i], 0), x(unknown[i], 1), x(unknown[i], 2)};
  }
}

}  // namespace toile
