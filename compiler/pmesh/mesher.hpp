// Meshes a garment's pieces until the nodes on their outlines agree across all seams.
#pragma once

#include <array>
#include <vector>

#include "compiler/pmesh/division.hpp"
#include "compiler/pmesh/pmesh.hpp"
#include "compiler/pmesh/triangulate.hpp"

namespace toile {

/// Each piece is refined by itself; where that wants more nodes on its outline they are given to all that is sewn
/// there, and the pieces concerned are meshed again, until none wants more. A piece's mesh thus depends on others
/// through its seams only. Can be asked for a finer mesh here and there, and meshes again only what that changes.
class GarmentMesher {
 public:
  GarmentMesher(const Garment& garment, const PMeshOptions& options);

  PMesh mesh();
  /// The number of triangles that mesh() gives, for less.
  int count();

  // Wishes for the next mesh; points are those of the last.
  bool is_on_outline(int point) const;
  bool is_on_line(int point) const;
  /// Divides the side of an outline between two neighbouring points in the middle.
  void want_side_split(int a, int b);
  /// Edges no longer than `edge` [m] about a place of a piece.
  void want_smaller(PieceId piece, Vec2 centre, double radius, double edge);
  /// At least so many triangles at a point of an outline. False where that has been wished before.
  bool want_fan(int point, int sectors);

 private:
  struct OutlineNode {
    int edge = 0, node = 0;  // as the first of two edges that meet there, or on one
  };
  struct Fan {
    int edge = 0;
    double arc = 0;
    int sectors = 0;
  };
  struct PieceState {
    std::vector<OutlineNode> outline;                  // loop after loop
    std::vector<int> loop_begin;                       // into outline, and its end
    std::vector<std::vector<OutlineNode>> line_sides;  // [line]: where its sides start
    std::vector<std::vector<int>> line_points;  // of each edge of the lines: the outline's points, then the lines'
    int points_on_lines = 0;                    // that are not on the outline
    TriangulationSize size;
    std::vector<Fan> fans;
    Triangulation triangulation;
    bool stale = true;
    bool improved = false;
  };

  void settle();
  void triangulate_piece(PieceId id, Outline outline);
  PlaneDomain lay_out(PieceState& piece, PieceId id) const;
  void lay_out_lines(PieceState& piece, PieceId id, PlaneDomain& domain) const;
  static double room_beside(const LineMark& crease, const Piece& piece);
  void pin_creases(PieceId id, PlaneDomain& domain) const;
  void pin_tucks(PieceId id, PlaneDomain& domain) const;
  void add_pins(const PieceState& piece, PlaneDomain& domain) const;
  std::vector<SideSplit> wishes(const PieceState& piece) const;
  void apply_splits();
  int point(EdgeNode node) const;
  PieceId piece_of(int point) const;

  const Garment& garment_;
  PMeshOptions options_;
  Division division_;
  std::vector<PieceState> pieces_;
  std::vector<int> first_point_;   // [piece], in the last mesh
  std::vector<SideSplit> splits_;  // asked for by want_side_split
};

/// What a piece's outline encloses, by its chords and arcs [m2].
double area_of(const Piece& piece);

}  // namespace toile
