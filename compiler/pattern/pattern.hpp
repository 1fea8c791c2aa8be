// The evaluated pattern: what a garment is before there is any mesh. Exact curves, seams, worn lines, cloth.
// Lengths in metres, angles in radians, SI throughout. Produced by compiler/evaluate, consumed by compiler/pmesh, the
// drawing and the runtime. Nothing here refers to syntax but for the Locations that say where a thing was written.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compiler/curve/curve.hpp"
#include "compiler/pattern/chart_spec.hpp"
#include "compiler/pattern/fabric_sheet.hpp"
#include "compiler/pattern/textile.hpp"
#include "grammar/source.hpp"

namespace toile {

using PieceId = int;

/// Which copy of a drawn edge: pieces on the fold and pieces cut in mirrored pairs have both.
enum class Side { Drawn, Mirrored };

/// How the cut line turns at the ends of an edge's allowance: both sides drawn on until they meet, cut off square to
/// the edge, cut so that the allowance lies flat when it is folded back, or with its corner taken off.
enum class AllowanceCorner { Mitred, Square, Mirrored, Bevelled };

/// A part of an edge by arc lengths along it as drawn [m].
struct DrawnSpan {
  double from = 0, to = 0;
};

/// One edge of a piece's outline or of a hole. A dart at an edge splits it: "waist" then comes as several edges of the
/// same name, told apart by `part`, with the dart's two legs ("dart1.left", "dart1.right") between them.
struct PieceEdge {
  std::string name;         // as a seam names it behind its piece; of a hole's edge with the hole's: "eye.rim"
  Side side = Side::Drawn;  // on a fold piece: which half it belongs to
  int part = 0;             // 0, 1, … along the direction of drawing when a dart or a seam divided the edge
  bool is_dart_leg = false;
  Curve curve;           // in the direction in which the outline is walked
  double allowance = 0;  // [m] seam allowance outside the edge
  Location written;
  DrawnSpan drawn{};          // which part of the edge as drawn
  bool pressed_onto = false;  // of a dart's leg: the dart is pressed to its side
  bool folded_under = false;  // in a pleat: the sewn line passes it by
  AllowanceCorner corner = AllowanceCorner::Mitred;
  bool against_drawing = false;  // the curve runs against the direction in which the edge was drawn
};

struct Notch {
  int edge = 0;   // number of the edge: Piece::edge()
  double at = 0;  // [m] arc length along that edge
  Location written;
};

/// A direction in the drawing in which a fold is pressed; Open: apart, half to either side.
enum class Press { Left, Right, Up, Down, Open };

struct Dart {
  std::string name;
  int left_leg = 0;  // numbers of edges: Piece::edge(); the legs meet at the tip
  int right_leg = 0;
  Vec2 tip;
  double width = 0;  // [m] at the mouth
  double depth = 0;  // [m] from the middle of the mouth to the tip
  Location written;
  std::optional<Vec2> other_tip{};  // of a dart inside the piece, whose legs meet at both of their ends
  bool trued = false;
  std::optional<Press> pressed{};  // as stated; which leg it is pressed onto the edges tell
};

enum class PleatStyle { Knife, Box, Inverted };

/// One turn of the cloth at an edge: three parts of it, as long as each other, that lie on each other and are sewn as
/// one.
struct Pleat {
  std::string name;
  int face = 0;   // numbers of edges, Piece::edge(): what lies uppermost,
  int under = 0;  // what is turned back below it at the fold,
  int back = 0;   // and what runs on below that from the inner fold
  Location written;
};

/// A line inside a piece: drawn by the script, to be seen or to be folded, or of a pleat. Where a pleat is folded the
/// line's cloth lies uppermost, is turned back below, or is what the fold comes to lie on.
struct LineMark {
  enum class Kind { Line, Crease, Fold, InnerFold, Placement } kind = Kind::Line;
  Curve curve;
  Location written;
  double angle = 0;  // [rad] of a crease, between the normals of its two sides: positive with the right side outside

  bool folded() const { return kind == Kind::Crease || kind == Kind::Fold || kind == Kind::InnerFold; }
};

/// A single place inside a piece.
struct PointMark {
  enum class Kind { Drill, Button, Buttonhole } kind = Kind::Drill;
  Vec2 at;
  double length = 0;  // [m] of a buttonhole, about its middle
  double angle = 0;   // [rad]
  Location written;
};

/// One piece of cloth as it is cut: unfolded (both halves of a piece on the fold), with darts cut as wedges. A piece
/// cut in mirrored pairs is two Pieces, the second with Side::Mirrored. The outline is closed and simple, and is walked
/// counter-clockwise (cloth on the left), right side of the cloth up.
struct Piece {
  std::string name;        // "front"; the mirrored copy is "front.mirrored"
  std::string drawn_name;  // "front" for both
  Side side = Side::Drawn;
  std::vector<PieceEdge> edges;
  std::vector<std::vector<PieceEdge>> holes;  // walked clockwise: they, too, have the cloth on their left
  std::vector<std::vector<PieceEdge>> lines;  // inside, with cloth on both sides, walked as drawn
  std::optional<LineSegment> fold;            // where it was folded, for drawing and for centring
  Vec2 warp{0, -1};         // unit vector: the direction of the warp (u) in the drawing; weft is perpendicular(warp)
  bool free_grain = false;  // it turns where it costs least when the piece is developed
  std::vector<Notch> notches;
  std::vector<Dart> darts;
  std::vector<Pleat> pleats;
  std::vector<LineMark> marks;
  std::vector<PointMark> spots;
  int quantity = 1;
  std::string label;               // what is written on it
  std::optional<ChartSpec> chart;  // drawn on a body: what stands here is in the chart, and is to be developed
  Location written;
  int layer = 0;                        // of garments worn over each other, from the inside out: Garment::layers
  std::optional<FabricSheet> fabric{};  // where it is not the garment's
  int plies = 1;                        // cut and sewn as one

  /// All edges in one numbering: those of the outline, then those of the holes, hole by hole, then those of the lines.
  int edge_count() const;
  const PieceEdge& edge(int number) const;
  PieceEdge& edge(int number);
  /// The number of the edge that follows on the same loop or line; -1 at the end of a line.
  int next_edge(int number) const;
  /// Whether it lies on a line inside the piece.
  bool is_inside(int number) const;

  bool has_own_cloth() const { return fabric || plies > 1; }
  /// What is told of it on the pattern: "silk, 2 plies"; empty where it is the garment's cloth.
  std::string own_cloth() const;
};

/// A reference to one edge of one piece.
struct EdgeRef {
  PieceId piece = 0;
  int edge = 0;  // number of the edge, those of holes included: Piece::edge()

  friend constexpr bool operator==(EdgeRef, EdgeRef) = default;
};

/// Edges walked one after another as one line. `forward` tells whether an edge is walked as its loop is.
struct ChainLink {
  EdgeRef edge;
  bool forward = true;
};
using Chain = std::vector<ChainLink>;

/// Two chains sewn together: the point at the fraction t of the first's arc length meets the point at the fraction t of
/// the second's (both chains are already directed so that this holds; `reversed` of the script is resolved). Nodes of
/// the mesh lie at equal fractions on both. A dart's legs are a seam like any other.
struct Seam {
  std::string name;
  Chain first;
  Chain second;
  enum class Fullness { None, Ease, Gather, Stretch } fullness = Fullness::None;
  double stated = 0;  // [m] the stated difference of lengths
  bool is_dart = false;
  Location written;
  bool is_pleat = false;  // the layers of a pleat at its edge
  bool is_layer = false;  // joins a further layer to a seam that is sewn already
  enum class Closure { Sewn, Zipped, Buttoned } closure = Closure::Sewn;
  bool open = false;          // a closure that is worn open: its edges are free
  std::optional<int> step{};  // in the order of sewing, where the script says it
  /// Arc lengths [m] along the two chains that come to lie on each other, ascending: tied notches, the ends of a
  /// stretch that takes all the fullness. Between them, and to the ends, nodes lie at equal fractions.
  std::vector<std::array<double, 2>> ties{};
  std::vector<std::array<double, 2>> notches{};  // those of them that are marked
  double angle = 0;  // [rad] at rest between the two sides' normals, as of a crease: an edge of a box
};

/// Edges worn at a line of the body.
struct Wear {
  Chain chain;       // in the script's order, each link directed so that the chain runs on continuously once sewn
  std::string line;  // name of the body's line, "waist"
  bool held = true;  // held there for good (a waistband), or only placed there to start with
  double from =
      0;  // fraction of the line's girth by which the chain's centring is turned from the front, ccw seen from above
  Location written;
};

/// Where a piece is put in space before it is sewn: its drawing's origin [m], and unit vectors of its x and its y.
struct Arrangement {
  PieceId piece = 0;
  std::array<double, 3> origin{}, across{}, up{};
  Location written;
};

/// One of several garments that are worn over each other and draped as one.
struct WornLayer {
  std::string name;
  FabricSheet fabric;
  Textile textile;
};

struct Garment {
  std::string name;
  std::vector<Piece> pieces;
  std::vector<Seam> seams;
  std::vector<Wear> wears;
  std::vector<Arrangement> arrangements;
  FabricSheet fabric;
  Textile textile;
  std::string drawn_on;  // the body that its pieces are drawn on; empty for a pattern that is drawn flat
  Location written;
  std::vector<WornLayer> layers{};  // from the inside out; empty for a garment that is worn alone

  /// The fabrics that its cloth is made of: one a layer, then those of the pieces that have their own, in their order.
  std::vector<FabricSheet> fabrics() const;
  /// The number of each piece's among them.
  std::vector<int> fabric_of_pieces() const;
};

/// Garments that are worn over each other as one, the innermost first. Pieces are called by their garment:
/// "shirt.front".
Garment worn_over_each_other(const std::vector<Garment>& inside_out);

}  // namespace toile
