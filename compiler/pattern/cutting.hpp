// From a drafted piece to the pieces of cloth that are cut from it. The steps work on a Piece that starts as the drawn
// outline and grows: its darts are cut, then it is unfolded or copied.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/pattern/draft.hpp"
#include "compiler/pattern/findings.hpp"
#include "compiler/pattern/pattern.hpp"

namespace toile {

/// A dart on an edge once it is cut. Its legs lead to the tip; where a pivot has closed it there are none.
struct CutDart {
  const DraftDart* draft = nullptr;
  std::string name;
  Vec2 tip;
  std::string edge;  // that it stood on first, and where on it as drawn
  DrawnSpan mouth;
  bool closed = false;
};

/// Where a pleat turns at an edge: places along it as drawn.
struct CutTurn {
  std::string name;
  std::string edge;
  double fold = 0, inner_fold = 0;  // [m]
  Location written;
};

/// What a garment's seams and worn lines need of a piece.
struct PieceUse {
  std::vector<DraftPlace> divisions;  // ends of parts of edges that are sewn or worn by themselves
  std::set<std::string> joined;       // edges that are sewn or worn
};

/// A drafted outline brought to counter-clockwise order, its holes clockwise. Loop 0 is the outline, then come the
/// holes, then the lines inside, which need not close. A hole on the fold, of which half is drawn, is a part of the
/// half's outline, between two parts of the fold.
struct DrawnPiece {
  Piece piece;
  std::vector<CutDart> darts;
  std::vector<CutTurn> turns;
  std::vector<DraftNotch> fold_notches;  // at the ends of pleats
  std::vector<DraftPlace> crease_ends;   // on the edges opposite

  int closed_count() const { return 1 + static_cast<int>(piece.holes.size()); }
  int loop_count() const { return closed_count() + static_cast<int>(piece.lines.size()); }
  const std::vector<PieceEdge>& loop(int i) const {
    if (i == 0) return piece.edges;
    return i < closed_count() ? piece.holes[i - 1] : piece.lines[i - closed_count()];
  }
  std::vector<PieceEdge>& loop(int i) {
    return const_cast<std::vector<PieceEdge>&>(static_cast<const DrawnPiece&>(*this).loop(i));
  }
  /// The number of an edge of a loop: Piece::edge().
  int number(int loop_index, int edge) const;
};

/// A place on an edge of a loop.
struct EdgePlace {
  int loop = 0;
  int edge = 0;
  double s = 0;  // [m] along its curve
};
/// Where a place on a drawn edge has come to lie; nothing where it was cut away.
std::optional<EdgePlace> find_place(const DrawnPiece& drawn, const std::string& edge, double at);
/// The place of a drawn edge that lies at `s` of the edge of a loop.
double drawn_place(const DrawnPiece& drawn, const EdgePlace& place);
/// The edge of that name and no other, for a dart's leg.
std::optional<EdgePlace> find_leg(const DrawnPiece& drawn, const std::string& name);
/// Puts an edge in two; the first keeps its index.
void divide_edge(DrawnPiece& drawn, const EdgePlace& place);
/// The same at a place of the drawn edge; nothing happens where it is divided already, ends or was cut away.
void divide_at(DrawnPiece& drawn, const std::string& edge, double at);
/// Whether a point lies in the cloth: inside the outline and in no hole.
bool in_cloth(const DrawnPiece& drawn, Vec2 point);

/// Checks the outline by itself: names, lengths, closure, crossings, area. False when it cannot be cut.
bool check_outline(const DraftPiece& draft, Findings& findings);
bool check_holes(const DraftPiece& draft, Findings& findings);
/// Lines inside lie on the cloth, cross nothing and touch the outline, if at all, with their ends. To be asked once
/// darts and pleats are cut.
bool check_lines(const DraftPiece& draft, const DrawnPiece& drawn, Findings& findings);
/// Darts, pleats and allowances stand at the rim of the cloth, not on a line inside.
bool check_rims(const DraftPiece& draft, Findings& findings);
/// Puts the edges on which lines end in two there, but for the fold.
void divide_at_lines(const DraftPiece& draft, DrawnPiece& drawn);

/// Whether half of the hole is drawn, from the fold to the fold.
bool is_half(const DraftPiece& draft, const DraftInner& hole);

/// For an outline that passed its check: edges with their allowances, holes clockwise.
DrawnPiece drawn_piece(const DraftPiece& draft);

/// The named edge of the outline, of a hole or of a line, or null and reported as unknown.
const DraftEdge* find_edge(const DraftPiece& draft, const std::string& edge, Location written, Findings& findings);

/// Cuts the darts into the drawn loops: wedges at their edges, and those inside the piece as holes.
bool cut_darts(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings);
/// Moves darts that are cut, or shares of them, to other places.
bool pivot_darts(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings);
/// Shortens the legs that end before their tips, and trues the edges of those darts that ask for it.
bool finish_darts(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings);
/// Folds the pleats: divides their edges and draws their lines.
bool cut_pleats(const DraftPiece& draft, const PieceUse& use, DrawnPiece& drawn, Findings& findings);
/// Sets the notches on the edges that remain, and lists the darts and parts of edges.
bool set_notches(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings);

/// Whether the piece can be laid on its fold: the edge is straight and all cloth lies on one side of it.
bool check_fold(const DraftPiece& draft, const DrawnPiece& drawn, Findings& findings);
/// Both halves of a piece on the fold as one.
Piece unfolded(const Piece& half, const std::string& fold);
/// The other piece of a mirrored pair, reflected in the line x = 0.
Piece mirrored_copy(const Piece& piece);

/// All of the above: one piece, or two for a mirrored pair; none when an error was found.
std::vector<Piece> cut_piece(const DraftPiece& draft, const PieceUse& use, Findings& findings);

}  // namespace toile
