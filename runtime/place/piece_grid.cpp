#include "runtime/place/piece_grid.hpp"

#include <algorithm>
#include <cmath>

namespace toile {

void PieceGrid::Box::add(Vec2 p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

int PieceGrid::column(double x) const {
  return std::clamp(static_cast<int>((x - box_.low.x) / cell_), 0, columns_ - 1);
}

int PieceGrid::row(double y) const {
  return std::clamp(static_cast<int>((y - box_.low.y) / cell_), 0, rows_ - 1);
}

PieceGrid::PieceGrid(const PMesh& mesh, PieceId piece) : mesh_(mesh) {
  const auto corner = [&](int t, std::size_t k) {
    return mesh.points[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][k])];
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.piece_of_triangle[t] != piece) continue;
    triangles_.push_back(static_cast<int>(t));
    for (std::size_t k = 0; k < 3; ++k) box_.add(corner(static_cast<int>(t), k));
  }
  if (triangles_.empty()) return;
  const Vec2 size = box_.high - box_.low;
  cell_ = std::max(std::sqrt(size.x * size.y / static_cast<double>(triangles_.size())), 1e-6);
  columns_ = 1 + static_cast<int>(size.x / cell_);
  rows_ = 1 + static_cast<int>(size.y / cell_);
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (const int t : triangles_) {
    Box own;
    for (std::size_t k = 0; k < 3; ++k) own.add(corner(t, k));
    for (int j = row(own.low.y); j <= row(own.high.y); ++j) {
      for (int i = column(own.low.x); i <= column(own.high.x); ++i) {
        cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)]
            .push_back(t);
      }
    }
  }
}

PieceGrid::Barycentric PieceGrid::barycentric(int triangle, Vec2 p) const {
  const auto& corners = mesh_.triangles[static_cast<std::size_t>(triangle)];
  const Vec2 a = mesh_.points[static_cast<std::size_t>(corners[0])];
  const Vec2 b = mesh_.points[static_cast<std::size_t>(corners[1])];
  const Vec2 c = mesh_.points[static_cast<std::size_t>(corners[2])];
  const double area = cross(b - a, c - a);
  const double wb = cross(p - a, c - a) / area, wc = cross(b - a, p - a) / area;
  return {1 - wb - wc, wb, wc};
}

void PieceGrid::search(const std::vector<int>& among, Vec2 p, int& best, double& inside, Barycentric& weights) const {
  for (const int t : among) {
    const Barycentric w = barycentric(t, p);
    const double least = std::min({w[0], w[1], w[2]});
    if (least > inside) {
      best = t;
      inside = least;
      weights = w;
    }
  }
}

int PieceGrid::locate(Vec2 p, Barycentric& weights) const {
  int best = -1;
  double inside = -std::numeric_limits<double>::max();
  if (triangles_.empty()) return best;
  search(cells_[static_cast<std::size_t>(row(p.y)) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(column(p.x))],
         p, best, inside, weights);
  if (inside < -0.2) search(triangles_, p, best, inside, weights);
  return best;
}

}  // namespace toile
