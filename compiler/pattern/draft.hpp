// A garment as it is drafted: what the evaluator has read off the script, names still names. make_garment() unfolds,
// cuts darts, pairs seams and checks the geometry.
#pragma once

#include <optional>
#include <string>
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
  std::string edge;
  double at = 0;     // [m] along the drawn edge, of the middle of the mouth
  double width = 0;  // [m]
  double depth = 0;  // [m]
  Location written;
  std::optional<Vec2> tip;  // where the script says it, else square to the mouth
};

struct DraftNotch {
  std::string edge;
  double at = 0;  // [m] along the drawn edge
  Location written;
};

struct DraftAllowance {
  std::string edge;  // empty: all edges without one of their own
  double width = 0;  // [m]
  Location written;
};

struct DraftHole {
  std::string name;
  std::vector<DraftEdge> edges;
  Location written;
};

/// Drawn in either direction; `fold` names the straight edge on which half a piece is laid.
struct DraftPiece {
  std::string name;
  std::vector<DraftEdge> outline;
  std::vector<DraftHole> holes;
  std::optional<std::string> fold;
  Location fold_written;
  bool mirrored = false;  // cut in mirrored pairs
  int quantity = 1;
  Vec2 warp{0, -1};
  std::vector<DraftDart> darts;
  std::vector<DraftNotch> notches;
  std::vector<DraftAllowance> allowances;
  std::string label;
  std::optional<ChartSpec> chart;  // drawn on a body
  Location written;
};

struct DraftEdgeRef {
  std::string piece;
  std::string edge;          // of a hole with its name: "eye.rim"
  std::optional<Side> side;  // only where the script says it: front.side.mirrored
  Location written;
};

struct DraftSeam {
  std::vector<DraftEdgeRef> first;
  std::vector<DraftEdgeRef> second;
  bool reversed = false;
  Seam::Fullness fullness = Seam::Fullness::None;
  std::optional<double> stated;  // [m]
  Location written;
};

struct DraftWear {
  std::vector<DraftEdgeRef> chain;
  std::string line;
  bool held = true;
  double from = 0;  // fraction of the girth
  Location written;
};

struct DraftGarment {
  std::string name;
  std::vector<DraftPiece> pieces;
  std::vector<DraftSeam> seams;
  std::vector<DraftWear> wears;
  FabricSheet fabric;
  Textile textile;
  std::string drawn_on;  // the name of a body, where pieces are drawn on one
  Location written;
};

/// Always returns a garment; it is fit for meshing when no Error was added. Codes E0301 to E0399.
///
/// Darts. The mouth lies on the edge, `width` of arc length about `at`; the tip stands on the perpendicular bisector of
/// the mouth's chord, `depth` inside the piece, so that both legs have one length. Edge `waist` then is two edges
/// `waist`, parts 0 and 1, and naming it in a seam or a worn line means all its parts.
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
/// Mirrored pairs. `cut 2 mirrored` is one pair: each of its two Pieces has half the quantity. The copy is reflected in
/// x = 0, its grain with it.
Garment make_garment(const DraftGarment& draft, std::vector<Diagnostic>& diagnostics);

}  // namespace toile
