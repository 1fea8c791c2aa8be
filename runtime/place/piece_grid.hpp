// Finds the triangle of a piece in which a place of its drawing lies.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "compiler/pmesh/pmesh.hpp"

namespace toile {

/// The triangles of one piece in a grid of square cells.
class PieceGrid {
 public:
  using Barycentric = std::array<double, 3>;

  PieceGrid(const PMesh& mesh, PieceId piece);
  /// The triangle that contains p, or failing that the one that p lies least outside of; -1 for a piece without any.
  int locate(Vec2 p, Barycentric& weights) const;

 private:
  struct Box {
    Vec2 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    Vec2 high{-std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
    void add(Vec2 p);
  };

  int column(double x) const;
  int row(double y) const;
  Barycentric barycentric(int triangle, Vec2 p) const;
  void search(const std::vector<int>& among, Vec2 p, int& best, double& inside, Barycentric& weights) const;

  const PMesh& mesh_;
  std::vector<int> triangles_;
  Box box_;
  double cell_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<int>> cells_;
};

}  // namespace toile
