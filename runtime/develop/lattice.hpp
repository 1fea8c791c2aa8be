// A coarse lattice over each piece of a pattern, whose nodes move it as a whole: quadratic B-splines in both
// directions. Where a slit parts what a node moves, each side of it has a node of its own.
#pragma once

#include <array>
#include <vector>

#include "compiler/curve/vec2.hpp"
#include "runtime/develop/flatten.hpp"

namespace toile {

class Lattice {
 public:
  static constexpr std::size_t held_by = 9;  // nodes move a place
  using Nodes = std::array<int, held_by>;

  /// `cells` along the longer side of each piece.
  Lattice(const FlatteningInput& input, int cells);

  int nodes() const { return nodes_; }
  /// Points of a cell that hang together are moved by the same nodes.
  int patches() const { return static_cast<int>(nodes_of_patch_.size()); }
  const Nodes& nodes_of(int patch) const { return nodes_of_patch_[static_cast<std::size_t>(patch)]; }
  int patch_of(int point) const { return patch_[static_cast<std::size_t>(point)]; }
  int piece_of(int point) const { return piece_[static_cast<std::size_t>(point)]; }
  /// Nodes next to each other.
  const std::vector<std::array<int, 2>>& links() const { return links_; }

  /// How much of the motion of the nodes of its patch a point takes.
  std::array<double, held_by> shares(int point) const;
  /// [1/m] How these grow over the plane about the middle of a triangle that has the point for a corner.
  std::array<Vec2, held_by> slopes(int point, Vec2 middle) const;

 private:
  struct Sheet {
    Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
    double cell = 1;
    int columns = 1, rows = 1, first_cell = 0;
  };
  struct Place {
    double x = 0, y = 0;  // from the corner of its cell, in cells
  };

  void find_pieces();
  void lay_sheets(int cells);
  void find_patches();
  void number_nodes();
  void number_node(const Sheet& sheet, int column, int row);
  void find_links();
  const Sheet& sheet_of(int point) const { return sheets_[static_cast<std::size_t>(piece_of(point))]; }
  int cell_of(int point) const { return cell_[static_cast<std::size_t>(point)]; }
  Place in_cell(int point, Vec2 place) const;

  const FlatteningInput& input_;
  std::vector<Sheet> sheets_;                               // of each piece
  std::vector<int> piece_, cell_, patch_;                   // of each point
  std::vector<std::vector<int>> patches_of_cell_, beside_;  // beside_: of each patch those that triangles join it to
  std::vector<Nodes> nodes_of_patch_;
  std::vector<std::array<int, 2>> links_;
  int nodes_ = 0, cells_ = 0;
};

}  // namespace toile
