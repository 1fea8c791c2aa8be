// A garment as it is drafted: what the evaluator has read off the script, names still names. make_garment() unfolds,
// cuts darts, pairs seams and checks the geometry.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/diag/diagnostic.hpp"
#include "compiler/pattern/pattern.hpp"

namespace toile {

struct DraftEdge {
  std::string name;
  Curve curve;
  Location written;
};

struct DraftDart {
  std::string name;  // "dart1", … when the script gives none
  std::string edge;  // empty: inside the piece, from one point to another
  double at = 0;     // [m] along the drawn edge, of the middle of the mouth
  double width = 0;  // [m]
  double depth = 0;  // [m]; not where a tip is given
  Location written;
  std::optional<Vec2> tip{};  // towards this point
  double short_of_tip = 0;    // [m] that the legs end before it; a pivot turns about the tip itself
  LineSegment inside{};       // from point to point, where it has no edge
  double widest = 0;          // [m] from the first of these points to where it is widest
  bool trued = false;         // its edge redrawn so that it runs on smoothly once the dart is closed
  std::optional<Press> pressed{};
};

/// [m] So wide is a dart where its piece is drawn on a body: a slit that must have two sides to be meshed.
inline double slit_width(double depth) {
  return std::min(0.002, depth / 20);
}

/// Moves a dart, or a share of it, to another place of the outline.
struct DraftPivot {
  std::string dart;
  double share = 1;
  std::string edge;
  double at = 0;     // [m] along the drawn edge
  std::string name;  // of what comes of it
  Location written;
};

struct DraftNotch {
  std::string edge;
  double at = 0;  // [m] along the drawn edge
  Location written;
};

struct DraftPlace {
  std::string edge;
  double at = 0;  // [m] along the drawn edge
};

/// The piece is slashed from one place to the other and the ends of the slash are opened.
struct DraftSpread {
  DraftPlace opened, other;
  double by = 0;        // [m] at `opened`
  double other_by = 0;  // [m] at `other`; zero where it is hinged there
  Location written;
};

/// `place` is that of a knife pleat's fold, of a box pleat's or an inverted pleat's middle.
struct DraftPleat {
  std::string name;  // "pleat1", … when the script gives none
  DraftPlace place;
  std::optional<DraftPlace> other_end;
  PleatStyle style = PleatStyle::Knife;
  double depth = 0;     // [m] from the fold to the inner fold: half of what a knife pleat takes
  double width = 0;     // [m] between the folds of a box pleat
  double stitched = 0;  // [m] that it is stitched down, as a tuck is
  std::optional<Press> pressed;
  Location written;
};

struct DraftAllowance {
  std::string edge;  // empty: all edges without one of their own
  double width = 0;  // [m]
  Location written;
  std::optional<AllowanceCorner> corner{};
};

/// A hole or a line inside a piece.
struct DraftInner {
  std::string name;
  std::vector<DraftEdge> edges;
  Location written;
};

/// Drawn in either direction; `fold` names the straight edge on which half a piece is laid.
struct DraftPiece {
  std::string name;
  std::vector<DraftEdge> outline;
  std::vector<DraftInner> holes;
  std::vector<DraftInner> lines;
  std::optional<std::string> fold;
  Location fold_written;
  bool mirrored = false;  // cut in mirrored pairs
  int quantity = 1;
  std::optional<FabricSheet> fabric;  // where it is not the garment's
  int plies = 1;
  Vec2 warp{0, -1};
  bool free_grain = false;  // the warp turns where it costs least when the piece is developed
  std::vector<DraftDart> darts;
  std::vector<DraftDart> tried;  // not made: a development says what each would gain
  std::vector<DraftPivot> pivots;
  std::vector<DraftSpread> spreads;
  std::vector<DraftPleat> pleats;
  std::vector<LineMark> marks;
  std::vector<PointMark> spots;
  std::vector<DraftNotch> notches;
  std::vector<DraftAllowance> allowances;
  std::string label;
  std::optional<ChartSpec> chart;  // drawn on a body
  Location written;
};

struct DraftEdgeRef {
  std::string piece;
  std::string edge;          // of a hole or a line with its name: "eye.rim"
  std::optional<Side> side;  // only where the script says it: front.side.mirrored
  Location written;
  std::optional<DrawnSpan> part{};  // of a part of the edge
};

/// A place on a seam's first chain: a length [m] from its start, or a fraction of it; or a length along one of its
/// edges as drawn.
struct DraftSeamPlace {
  double value = 0;
  bool is_fraction = false;
  std::string piece{}, edge{};  // of which it is told, where it is told of an edge
};

struct DraftSeam {
  std::vector<DraftEdgeRef> first;
  std::vector<DraftEdgeRef> second;
  bool reversed = false;
  Seam::Fullness fullness = Seam::Fullness::None;
  std::optional<double> stated;  // [m]
  Location written;
  std::vector<std::vector<DraftEdgeRef>> layers{};                   // further chains sewn into the same seam
  std::optional<std::pair<DraftSeamPlace, DraftSeamPlace>> taken{};  // the stretch that takes the difference
  std::vector<DraftSeamPlace> notches{};
  Seam::Closure closure = Seam::Closure::Sewn;
  bool open = false;
  bool is_layer = false;      // one of the layers of another seam, which sews its first chain
  std::optional<int> step{};  // in the order of sewing
  double angle = 0;           // [rad] at rest, as of a crease
};

struct DraftWear {
  std::vector<DraftEdgeRef> chain;
  std::string line;
  bool held = true;
  double from = 0;  // fraction of the girth
  Location written;
};

/// A piece stands upright at first and faces the front: its drawing's x goes to the wearer's left, its y up. Then it is
/// turned about the axes in space through its origin, x (to the left), y (to the back) and z (up), one after the other.
struct DraftArrangement {
  std::string piece;
  std::array<double, 3> at{};    // [m] of the drawing's origin
  std::array<double, 3> turn{};  // [rad]
  Location written;
};

struct DraftGarment {
  std::string name;
  std::vector<DraftPiece> pieces;
  std::vector<DraftSeam> seams;
  std::vector<DraftWear> wears;
  std::vector<DraftArrangement> arrangements;
  FabricSheet fabric;
  Textile textile;
  std::string drawn_on;  // the name of a body, where pieces are drawn on one
  Location written;
};

/// The edge of the outline, of a hole or of a line ("eye.rim") as it was drawn, or null.
const DraftEdge* drafted_edge(const DraftPiece& piece, const std::string& name);

/// Always returns a garment; it is fit for meshing when no Error was added. Codes E0301 to E0399.
///
/// Darts. The mouth lies on the edge, `width` of arc length about `at`; the tip stands on the perpendicular bisector of
/// the mouth's chord, `depth` inside the piece, so that both legs have one length. Edge `waist` then is two edges
/// `waist`, parts 0 and 1, and naming it in a seam or a worn line means all its parts.
///
/// Where a tip is given the legs lead there. Their lengths may then differ, so such a dart is always trued: half way
/// into what remains of its edge on either side (but no further than twice the width) the edge leaves its line for a
/// smooth curve drawn over the closed dart, which the legs end on. A dart inside the piece is a hole with four corners,
/// its two sides sewn to each other; both of its tips are tips of cones. A pivot cuts the piece from the tip to the new
/// place and turns what lies between there and the dart about the tip (of the two parts the one without the fold, else
/// the shorter one); the angle that the dart loses opens there.
///
/// How seams are paired. A piece on the fold, or cut in mirrored pairs, has each edge twice: drawn and mirrored. `sew a
/// to b` then means both pairs. Which pairs, the drawing tells: walk both drawn lines with their cloth on the left;
/// where their chords point the same way (positive dot product) the two lines face the same side - two side seams, two
/// shoulders, a centre back and itself - and drawn meets mirrored; where they point against each other (a bodice's
/// lower and a skirt's upper edge, the legs of a dart) drawn meets drawn, and so it does where one of them is closed by
/// itself, as the rim of a hole is. Of chains the first edges decide; the further edges of a chain are the copies that
/// run on from them once sewn. A side named in the script (front.side.mirrored) means that one alone. An edge without a
/// copy that is sewn to one with two takes both, as a chain, when the lengths
/// agree. Two chains meet end to start ("opposite", both walked with their cloth on the left) as right sides laid
/// together do, which keeps the surface orientable; `reversed` sews start to start. In closed lines the edges named
/// first meet each other.
///
/// Lengths. The two sides of a seam agree within 0.5 mm or a thousandth of the longer one. With `ease`, `gather` or
/// `stretch` either may be the longer: the difference must not exceed the stated amount, and where none is stated, a
/// tenth of the longer one for ease and stretch, anything for gather.
///
/// Arranging. A mirrored copy stands opposite to the drawn one, on the other side of x = 0.
///
/// Mirrored pairs. `cut 2 mirrored` is one pair: each of its two Pieces has half the quantity. The copy is reflected in
/// x = 0, its grain with it.
Garment make_garment(const DraftGarment& draft, std::vector<Diagnostic>& diagnostics);

}  // namespace toile
