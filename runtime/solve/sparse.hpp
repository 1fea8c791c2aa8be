// A symmetric sparse matrix whose pattern is fixed once, its assembly from elements, and its Cholesky factor.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/mesh/vector.hpp"

namespace toile {

/// Lower triangle by compressed columns. Unknowns that are held have no row: `reduced[i]` is -1 for them.
class SparseMatrix {
 public:
  /// `elements`: the unknowns (before reduction) that each element couples.
  SparseMatrix(std::vector<int> reduced, const std::vector<std::vector<int>>& elements);

  /// The same with its rows numbered anew: row order[i] becomes row i. Values are zero.
  SparseMatrix reordered(const std::vector<int>& order) const;

  int rows() const { return static_cast<int>(column_start_.size()) - 1; }
  const std::vector<int>& reduced() const { return reduced_; }
  const std::vector<int>& column_start() const { return column_start_; }
  const std::vector<int>& row_index() const { return row_index_; }
  const std::vector<double>& values() const { return values_; }

  /// Whether the pattern has the entry; true for held unknowns, whose entries are dropped.
  bool has(int i, int j) const;
  void set_zero();
  /// Adds to entry (i, j) and by symmetry (j, i), unknowns before reduction, i == j once. The entry must be in the
  /// pattern.
  void add(int i, int j, double value);
  void add_diagonal(std::span<const double> diagonal, double factor);  // of all unknowns

  /// Places of an element's lower triangle (row-wise, i >= j in the element's order) in `values`, -1 for held ones.
  std::vector<std::int32_t> places(const std::vector<int>& element) const;
  void add_at(std::int32_t place, double value) { values_[static_cast<std::size_t>(place)] += value; }
  double diagonal(int row) const {
    return values_[static_cast<std::size_t>(column_start_[static_cast<std::size_t>(row)])];
  }

 private:
  SparseMatrix() = default;
  /// Takes the rows of each column, in any order and as often as they come; column j's begin at start[j].
  void fill(const std::vector<std::size_t>& start, std::vector<int>& rows);
  std::int32_t find(int row, int column) const;

  std::vector<int> reduced_;
  std::vector<int> column_start_;
  std::vector<int> row_index_;
  std::vector<double> values_;
};

/// Supernodal sparse Cholesky (CHOLMOD).
class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;

  /// Finds an order of the rows that keeps the factor sparse; once for a pattern.
  void analyse(const SparseMatrix& matrix);
  /// That order, for SparseMatrix::reordered.
  std::vector<int> good_order(const SparseMatrix& matrix) const;
  /// Takes the rows as they come: no entry has to be moved before each factorisation.
  void analyse_in_order(const SparseMatrix& matrix);
  /// From now on orders are found by least degree: sooner, and of plane meshes no worse up to some ten thousand points.
  void order_by_degree();
  /// From now on columns that are nearly alike are taken together, for some zeros more: of use where there are two
  /// unknowns a point of a plane mesh. To be said before a pattern is analysed.
  void join_more_columns();
  /// False when the matrix is not positive definite.
  bool factorise(const SparseMatrix& matrix);
  Vector solve(const Vector& right) const;
  /// The same for a right side of all unknowns, the matrix's held ones among them: those come out 0.
  Vector solve_free(const SparseMatrix& matrix, const Vector& right) const;
  int factorisations() const { return factorisations_; }

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
  int factorisations_ = 0;
};

}  // namespace toile
