#include "runtime/develop/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr int splines_across = 3;  // nodes that move a place, in each direction
using Spline = std::array<double, splines_across>;

/// What the three splines over a cell are at a place in it, from 0 to 1.
Spline spline_shares(double s) {
  return {0.5 * (1 - s) * (1 - s), 0.5 + s * (1 - s), 0.5 * s * s};
}
Spline spline_slopes(double s) {
  return {s - 1, 1 - 2 * s, s};
}

class Groups {
 public:
  explicit Groups(std::size_t count) : leader_(count) { std::iota(leader_.begin(), leader_.end(), 0); }
  int leader(int i) {
    while (leader_[index(i)] != i) i = leader_[index(i)] = leader_[index(leader_[index(i)])];
    return i;
  }
  void join(int a, int b) { leader_[index(leader(b))] = leader(a); }
  /// Of each member the number of its group, by the order of their first members.
  std::pair<std::vector<int>, int> numbered() {
    std::vector<int> number(leader_.size(), -1), of(leader_.size());
    int groups = 0;
    for (std::size_t i = 0; i < leader_.size(); ++i) {
      int& known = number[index(leader(static_cast<int>(i)))];
      if (known < 0) known = groups++;
      of[i] = known;
    }
    return {std::move(of), groups};
  }

 private:
  std::vector<int> leader_;
};

}  // namespace

Lattice::Lattice(const FlatteningInput& input, int cells) : input_(input) {
  find_pieces();
  lay_sheets(cells);
  find_patches();
  number_nodes();
  find_links();
}

void Lattice::find_pieces() {
  Groups groups(input_.start.size());
  for (const auto& t : input_.triangles) {
    groups.join(t[0], t[1]);
    groups.join(t[0], t[2]);
  }
  auto [of, count] = groups.numbered();
  piece_ = std::move(of);
  sheets_.resize(index(count));
}

void Lattice::lay_sheets(int cells) {
  for (std::size_t p = 0; p < piece_.size(); ++p) {
    Sheet& sheet = sheets_[index(piece_[p])];
    const Vec2 at = input_.start[p];
    sheet.low = {std::min(sheet.low.x, at.x), std::min(sheet.low.y, at.y)};
    sheet.high = {std::max(sheet.high.x, at.x), std::max(sheet.high.y, at.y)};
  }
  for (Sheet& sheet : sheets_) {
    const Vec2 extent = sheet.high - sheet.low;
    sheet.cell = std::max(std::max(extent.x, extent.y) / cells, 1e-9);
    sheet.columns = std::max(1, static_cast<int>(std::ceil(extent.x / sheet.cell - 1e-6)));
    sheet.rows = std::max(1, static_cast<int>(std::ceil(extent.y / sheet.cell - 1e-6)));
    sheet.first_cell = cells_;
    cells_ += sheet.columns * sheet.rows;
  }
  for (std::size_t p = 0; p < piece_.size(); ++p) {
    const Sheet& sheet = sheets_[index(piece_[p])];
    const Vec2 at = (input_.start[p] - sheet.low) / sheet.cell;
    const int i = std::min(static_cast<int>(at.x), sheet.columns - 1);
    const int j = std::min(static_cast<int>(at.y), sheet.rows - 1);
    cell_.push_back(sheet.first_cell + j * sheet.columns + i);
  }
}

void Lattice::find_patches() {
  Groups groups(cell_.size());
  for (const auto& t : input_.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell_of(t[k]) == cell_of(t[(k + 1) % 3])) groups.join(t[k], t[(k + 1) % 3]);
    }
  }
  auto [of, count] = groups.numbered();
  patch_ = std::move(of);
  nodes_of_patch_.assign(index(count), Nodes{});
  beside_.resize(index(count));
  patches_of_cell_.resize(index(cells_));
  for (std::size_t p = 0; p < patch_.size(); ++p) {
    std::vector<int>& known = patches_of_cell_[index(cell_[p])];
    if (std::find(known.begin(), known.end(), patch_[p]) == known.end()) known.push_back(patch_[p]);
  }
  for (const auto& t : input_.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = patch_of(t[k]), b = patch_of(t[(k + 1) % 3]);
      std::vector<int>& known = beside_[index(a)];
      if (a == b || std::find(known.begin(), known.end(), b) != known.end()) continue;
      known.push_back(b);
      beside_[index(b)].push_back(a);
    }
  }
}

void Lattice::number_nodes() {
  for (const Sheet& sheet : sheets_) {
    for (int row = 0; row < sheet.rows + splines_across - 1; ++row) {
      for (int column = 0; column < sheet.columns + splines_across - 1; ++column) number_node(sheet, column, row);
    }
  }
}

/// Of all patches that lie under one spline those are moved together which hang together there.
void Lattice::number_node(const Sheet& sheet, int column, int row) {
  struct Moved {
    int patch;
    std::size_t corner;  // of the nodes of that patch, which one this is
  };
  std::vector<Moved> moved;
  for (int j = std::max(0, row - splines_across + 1); j <= std::min(row, sheet.rows - 1); ++j) {
    for (int i = std::max(0, column - splines_across + 1); i <= std::min(column, sheet.columns - 1); ++i) {
      for (const int patch : patches_of_cell_[index(sheet.first_cell + j * sheet.columns + i)]) {
        moved.push_back({patch, index(splines_across * (row - j) + column - i)});
      }
    }
  }
  Groups groups(moved.size());
  for (std::size_t a = 0; a < moved.size(); ++a) {
    const std::vector<int>& beside = beside_[index(moved[a].patch)];
    for (std::size_t b = 0; b < a; ++b) {
      if (std::find(beside.begin(), beside.end(), moved[b].patch) == beside.end()) continue;
      groups.join(static_cast<int>(b), static_cast<int>(a));
    }
  }
  const auto [of, count] = groups.numbered();
  for (std::size_t k = 0; k < moved.size(); ++k) {
    nodes_of_patch_[index(moved[k].patch)][moved[k].corner] = nodes_ + of[k];
  }
  nodes_ += count;
}

void Lattice::find_links() {
  for (const Nodes& nodes : nodes_of_patch_) {
    for (std::size_t k = 0; k < held_by; ++k) {
      if (k % splines_across + 1 < splines_across) links_.push_back({nodes[k], nodes[k + 1]});
      if (k + splines_across < held_by) links_.push_back({nodes[k], nodes[k + splines_across]});
    }
  }
  std::sort(links_.begin(), links_.end());
  links_.erase(std::unique(links_.begin(), links_.end()), links_.end());
}

Lattice::Place Lattice::in_cell(int point, Vec2 place) const {
  const Sheet& sheet = sheet_of(point);
  const int cell = cell_of(point) - sheet.first_cell;
  const Vec2 at = (place - sheet.low) / sheet.cell;
  const int row = cell / sheet.columns;
  return {at.x - cell % sheet.columns, at.y - row};
}

std::array<double, Lattice::held_by> Lattice::shares(int point) const {
  const Place at = in_cell(point, input_.start[index(point)]);
  const Spline x = spline_shares(at.x), y = spline_shares(at.y);
  std::array<double, held_by> all{};
  for (std::size_t k = 0; k < held_by; ++k) all[k] = x[k % splines_across] * y[k / splines_across];
  return all;
}

std::array<Vec2, Lattice::held_by> Lattice::slopes(int point, Vec2 middle) const {
  const Place at = in_cell(point, middle);
  const Spline x = spline_shares(at.x), y = spline_shares(at.y), by_x = spline_slopes(at.x), by_y = spline_slopes(at.y);
  const double cell = sheet_of(point).cell;
  std::array<Vec2, held_by> all{};
  for (std::size_t k = 0; k < held_by; ++k) {
    all[k] =
        Vec2{by_x[k % splines_across] * y[k / splines_across], x[k % splines_across] * by_y[k / splines_across]} / cell;
  }
  return all;
}

}  // namespace toile
