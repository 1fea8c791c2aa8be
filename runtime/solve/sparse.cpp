#include "runtime/solve/sparse.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace toile {

SparseMatrix::SparseMatrix(std::vector<int> reduced, const std::vector<std::vector<int>>& elements)
    : reduced_(std::move(reduced)) {
  int rows = 0;
  for (const int r : reduced_) rows = std::max(rows, r + 1);
  std::vector<int> free;
  const auto for_each_entry = [&](const auto& enter) {
    for (int r = 0; r < rows; ++r) enter(r, r);
    for (const std::vector<int>& element : elements) {
      free.clear();
      for (const int i : element) {
        if (reduced_[static_cast<std::size_t>(i)] >= 0) free.push_back(reduced_[static_cast<std::size_t>(i)]);
      }
      for (const int row : free) {
        for (const int column : free) {
          if (row > column) enter(row, column);
        }
      }
    }
  };
  std::vector<std::size_t> start(static_cast<std::size_t>(rows) + 1, 0);
  for_each_entry([&](int, int column) { ++start[static_cast<std::size_t>(column) + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::size_t> next = start;
  std::vector<int> entries(start.back());
  for_each_entry([&](int row, int column) { entries[next[static_cast<std::size_t>(column)]++] = row; });
  fill(start, entries);
}

SparseMatrix SparseMatrix::reordered(const std::vector<int>& order) const {
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  SparseMatrix matrix;
  matrix.reduced_ = reduced_;
  for (int& row : matrix.reduced_) {
    if (row >= 0) row = place[static_cast<std::size_t>(row)];
  }
  const auto for_each_entry = [&](const auto& enter) {
    for (std::size_t column = 0; column < order.size(); ++column) {
      for (int k = column_start_[column]; k < column_start_[column + 1]; ++k) {
        const int a = place[column], b = place[static_cast<std::size_t>(row_index_[static_cast<std::size_t>(k)])];
        enter(std::max(a, b), static_cast<std::size_t>(std::min(a, b)));
      }
    }
  };
  std::vector<std::size_t> start(order.size() + 1, 0);
  for_each_entry([&](int, std::size_t column) { ++start[column + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::size_t> next = start;
  std::vector<int> entries(start.back());
  for_each_entry([&](int row, std::size_t column) { entries[next[column]++] = row; });
  matrix.fill(start, entries);
  return matrix;
}

void SparseMatrix::fill(const std::vector<std::size_t>& start, std::vector<int>& rows) {
  column_start_ = {0};
  row_index_.clear();
  row_index_.reserve(rows.size());
  std::vector<std::size_t> seen(start.size(), 0);  // the last column, counted from 1, that has the row
  for (std::size_t column = 0; column + 1 < start.size(); ++column) {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(start[column]);
    const auto end = std::remove_if(begin, rows.begin() + static_cast<std::ptrdiff_t>(start[column + 1]), [&](int row) {
      return std::exchange(seen[static_cast<std::size_t>(row)], column + 1) == column + 1;
    });
    std::sort(begin, end);
    row_index_.insert(row_index_.end(), begin, end);
    column_start_.push_back(static_cast<int>(row_index_.size()));
  }
  values_.assign(row_index_.size(), 0.0);
}

bool SparseMatrix::has(int i, int j) const {
  const int row = reduced_[static_cast<std::size_t>(i)], column = reduced_[static_cast<std::size_t>(j)];
  if (row < 0 || column < 0) return true;
  const int last = column_start_[static_cast<std::size_t>(std::min(row, column)) + 1];
  const std::int32_t place = find(row, column);
  return place < last && row_index_[static_cast<std::size_t>(place)] == std::max(row, column);
}

void SparseMatrix::set_zero() {
  std::fill(values_.begin(), values_.end(), 0.0);
}

std::int32_t SparseMatrix::find(int row, int column) const {
  if (row < column) std::swap(row, column);
  const auto begin = row_index_.begin() + column_start_[static_cast<std::size_t>(column)];
  const auto end = row_index_.begin() + column_start_[static_cast<std::size_t>(column) + 1];
  return static_cast<std::int32_t>(std::lower_bound(begin, end, row) - row_index_.begin());
}

void SparseMatrix::add(int i, int j, double value) {
  const int row = reduced_[static_cast<std::size_t>(i)], column = reduced_[static_cast<std::size_t>(j)];
  if (row < 0 || column < 0) return;
  values_[static_cast<std::size_t>(find(row, column))] += value;
}

void SparseMatrix::add_diagonal(std::span<const double> diagonal, double factor) {
  for (std::size_t i = 0; i < reduced_.size(); ++i) {
    const int row = reduced_[i];
    if (row >= 0)
      values_[static_cast<std::size_t>(column_start_[static_cast<std::size_t>(row)])] += factor * diagonal[i];
  }
}

std::vector<std::int32_t> SparseMatrix::places(const std::vector<int>& element) const {
  std::vector<std::int32_t> places;
  places.reserve(element.size() * (element.size() + 1) / 2);
  for (std::size_t i = 0; i < element.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const int row = reduced_[static_cast<std::size_t>(element[i])];
      const int column = reduced_[static_cast<std::size_t>(element[j])];
      places.push_back(row < 0 || column < 0 ? -1 : find(row, column));
    }
  }
  return places;
}

}  // namespace toile
