// From names in a script to chains of edges that are sewn together or worn.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/pattern/draft.hpp"
#include "compiler/pattern/findings.hpp"
#include "compiler/pattern/pattern.hpp"

namespace toile {

Chain reversed(const Chain& chain);
double length(const std::vector<Piece>& pieces, const Chain& chain);

/// Which corners of the pieces are one once the seams known so far are sewn.
class SewnCorners {
 public:
  explicit SewnCorners(const std::vector<Piece>& pieces);
  /// The class of corners at a link's start and end, in its direction.
  int start(const ChainLink& link) const;
  int end(const ChainLink& link) const;
  /// Whether `next` starts at the very corner of the piece where `link` ends, without any seam.
  bool adjacent(const ChainLink& link, const ChainLink& next) const;
  /// Unites the ends of the two chains, and their inner corners that meet.
  void sew(const Seam& seam);

 private:
  int corner_at_start(const ChainLink& link) const;
  void unite_lines_with_outlines();
  int find(int corner) const;
  void unite(int a, int b);

  const std::vector<Piece>& pieces_;
  std::vector<int> first_corner_;  // of each piece: its edges' starts, then the ends of its lines
  std::vector<int> same_corner_;   // of each corner the first one in its piece that lies at the same place
  mutable std::vector<int> parent_;
};

/// One copy of one edge that a chain may run through: its parts in a row.
struct Strand {
  int reference = 0;  // which reference of the chain it stands for
  Side side = Side::Drawn;
  Chain links;
};

/// Strands in the order and direction in which they run on once sewn, the first of them leading.
struct LinedUp {
  std::vector<Strand> strands;
  std::vector<Strand> left_over;  // those that could not be joined on
};
/// With `one_of_each`, a reference is served by one of its strands and the others are dropped.
LinedUp line_up(const std::vector<Strand>& strands, bool one_of_each, const SewnCorners& corners);
Chain joined(const std::vector<Strand>& strands);

/// A drafted reference that has been found.
struct FoundEdge {
  const DraftEdgeRef* written = nullptr;
  bool copied = false;                         // drawn and mirrored both exist
  std::array<std::optional<Chain>, 2> copies;  // by Side, walked with the cloth on the left; empty if not cut
  bool free() const { return copied && !written->side; }  // both copies are meant, or one to be chosen
  bool cut() const { return copies[0].has_value(); }
};

/// Finds edges by name among the drafted pieces and the pieces cut from them.
class EdgeFinder {
 public:
  EdgeFinder(const DraftGarment& draft, const std::vector<Piece>& pieces);
  /// Reports what cannot be found, each reference for itself; nullopt if any.
  std::optional<std::vector<FoundEdge>> find(const std::vector<DraftEdgeRef>& references, const char* deed,
                                             Findings& findings) const;

 private:
  std::optional<FoundEdge> find(const DraftEdgeRef& reference, const char* deed, Findings& findings) const;
  /// All parts of one copy of an edge; of a part of the edge those within it.
  std::optional<Chain> parts_of(const DraftEdgeRef& reference, Side side) const;

  const DraftGarment& draft_;
  const std::vector<Piece>& pieces_;
  std::unordered_map<std::string_view, const DraftPiece*> drafted_;      // by name
  std::unordered_map<std::string_view, std::vector<PieceId>> cut_from_;  // by the name they are drawn by
};

/// Both copies of an edge, in the order in which one runs on into the other when walked with the cloth on the left, or
/// on the right.
std::vector<Strand> both_copies(const FoundEdge& edge, int reference, bool cloth_on_left, const SewnCorners& corners);

/// "front.side", "front.side.mirrored".
std::string edge_name(const FoundEdge& edge, std::optional<Side> side);

/// Whether one of the two chains runs over lines inside a piece.
bool is_sewn_upon(const Seam& seam, const std::vector<Piece>& pieces);

/// The legs of every dart, sewn from the mouth to the tip, and the layers of every pleat, sewn from its folds on.
std::vector<Seam> dart_seams(const std::vector<Piece>& pieces, SewnCorners& corners);
/// For every `sew` of the script the seams it stands for; none where it cannot be resolved. `corners` comes out sewn.
std::vector<std::vector<Seam>> resolve_seams(const DraftGarment& draft, const std::vector<Piece>& pieces,
                                             SewnCorners& corners, Findings& findings);
/// Worn lines; that they run on continuously is only demanded when the garment is `complete`.
std::vector<Wear> resolve_wears(const DraftGarment& draft, const std::vector<Piece>& pieces,
                                const std::vector<std::vector<Seam>>& seams, const SewnCorners& corners, bool complete,
                                Findings& findings);

/// Ties the seam's notches and the ends of the stretch that takes its fullness; false after a mistake.
bool tie_places(const DraftSeam& draft, const std::vector<Piece>& pieces, Seam& seam, Findings& findings);
/// Marks the notches of seams on both of their sides.
void add_tied_notches(const std::vector<Seam>& seams, std::vector<Piece>& pieces);

/// Each edge is sewn once, and not point by point to itself.
std::set<std::size_t> check_sewn_once(const DraftGarment& draft, const std::vector<std::vector<Seam>>& seams,
                                      const std::vector<Piece>& pieces, Findings& findings);
void check_worn_once(const std::vector<Wear>& wears, const std::vector<Piece>& pieces, Findings& findings);
/// [m] Along a worn chain to the middle of the edge named first, which comes to the front: its mirrored copy included,
/// and its parts between darts.
double worn_centre(const std::vector<Piece>& pieces, const Chain& chain, bool closed);
/// Warns of a copy that is worn on the other side of the body than that where it is sewn, and of a back worn in front.
void check_worn_sides(const DraftGarment& draft, const Garment& garment, const SewnCorners& corners,
                      Findings& findings);
/// The two sides of a seam are equally long within half a millimetre or a thousandth, or differ as the script allows.
void check_lengths(const DraftGarment& draft, const std::vector<std::vector<Seam>>& seams,
                   const std::vector<Piece>& pieces, const std::set<std::size_t>& told, Findings& findings);

/// Warns of a seam along whose line a piece is left for another place of the same piece.
void check_gaps(const Garment& garment, Findings& findings);

/// Of a garment that is worn no seam sews the right side of the cloth to the wrong one; of others that is asked about.
void check_sides(const DraftGarment& draft, const std::vector<std::vector<Seam>>& seams,
                 const std::vector<Piece>& pieces, Findings& findings);
/// A seam of two pieces that explains why lines which should run on from one to the other do not.
struct TwistedSeam {
  Location written;
  bool reversed = false;  // it is so by the script's word
  std::string remedy;     // what to sew instead; empty for leaving out `reversed`
};
std::optional<TwistedSeam> find_twist(const DraftGarment& draft, const std::vector<std::vector<Seam>>& seams,
                                      const std::vector<Piece>& pieces, PieceId a, PieceId b);

/// Every piece hangs together with the rest by seams, or is worn.
void check_ties(const DraftGarment& draft, const Garment& garment, Findings& findings);

}  // namespace toile
