// The P-mesh: every piece of a garment as triangles in the plane (paper, section 3).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "compiler/curve/vec2.hpp"
#include "compiler/pattern/pattern.hpp"

namespace toile {

/// Flat arrays with integer ids. Triangles are counter-clockwise in their piece's drawing; the triangles of a piece are
/// contiguous and so are its vertices, pieces in the garment's order.
struct PMesh {
  std::vector<Vec2> points;                   // [m] in the piece's drawing
  std::vector<std::array<int, 3>> triangles;  // into points
  std::vector<PieceId> piece_of_triangle;
  std::vector<PieceId> piece_of_point;
  std::vector<int> layer_of_piece;   // of garments worn over each other, from the inside out; empty: all of one
  std::vector<int> fabric_of_piece;  // of Garment::fabrics(); empty: all of one
  std::vector<Vec2> warp_of_piece;  // unit vector of the warp in the drawing: u = p . warp, v = p . perpendicular(warp)

  /// The vertices along each edge of each piece, first to last, and the arc length of each on the exact curve.
  struct EdgeNodes {
    std::vector<int> points;
    std::vector<double> arc;  // [m]
  };
  std::vector<std::vector<EdgeNodes>> edge_nodes;  // [piece][edge], numbered as by Piece::edge()

  /// The vertices that a seam joins, pair by pair in the order of its chains. Within a run neighbours bound a side.
  struct SewnRun {
    std::vector<int> first, second;
  };
  std::vector<std::vector<SewnRun>> sewn;  // [seam]
};

struct PMeshOptions {
  double target_edge = 0.015;   // [m]
  double chord_error = 0.0002;  // [m] how far a chord may stray from its curve
  /// Outlines are divided at least this many times along a seam, worn line or free edge: a strict complex may ask for
  /// more.
  int least_divisions = 1;
};

/// Sewn chains share their nodes: equal fractions of arc length on both. Corners of two chains that face each other
/// within a twentieth of the target edge are one node, and between such pairs the fractions are equal.
/// Angles are at least 20 degrees, 99 % of them at least 25, but at sharp corners of the outline and where the outline
/// asks for sides below 1/128 of the target edge. A target so small that it would take more than 400,000 triangles is
/// raised. Throws nothing: a garment that passed the compiler's checks can be meshed.
PMesh make_pmesh(const Garment& garment, const PMeshOptions& options);

/// The target edge at which a garment comes to about `triangles` triangles.
double edge_for_triangles(const Garment& garment, int triangles);

/// Stable text for `toile compile --emit pmesh`.
std::string emit(const PMesh& mesh, const Garment& garment);

}  // namespace toile
