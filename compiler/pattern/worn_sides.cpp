// Which side of its wearer the cloth comes to lie on, and copies that are worn on the other one.
#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

using Heading = std::complex<double>;  // about the wearer: 1 is the front and i the wearer's left
using LinkKey = std::pair<int, int>;

constexpr double clear_direction = 0.2;  // of what is summed, beyond which a sum of directions says something
constexpr int samples_of_edge = 8;
constexpr double back_to_front = 0.375;  // of a turn, beyond which the back is rather in front than at a side
constexpr double least_spread = 1e-3;    // [m] between places of a piece that tell a direction

/// A point of a piece, and where it comes to lie: as a fraction of a turn from the front to the left, running on from
/// one point to the next.
struct Sighting {
  Vec2 at;
  Side side = Side::Drawn;
  double fraction = 0;
};

Heading heading(double fraction) {
  return std::polar(1.0, 2 * std::numbers::pi * fraction);
}

Vec2 place_at(const Curve& curve, double fraction) {
  return curve.at(fraction * curve.length());
}

LinkKey link_key(const ChainLink& link) {
  return {link.edge.piece, link.edge.edge};
}

/// The side of the body that a line of a limb is on: +1 the left, -1 the right, 0 for a line of the trunk.
int limb_side(const std::string& line) {
  if (line.starts_with("left_")) return 1;
  return line.starts_with("right_") ? -1 : 0;
}

const char* side_word(int side) {
  return side > 0 ? "left" : "right";
}

bool has_word(std::string_view name, std::string_view wanted) {
  while (!name.empty()) {
    const std::size_t end = std::min(name.find('_'), name.size());
    std::string_view part = name.substr(0, end);
    while (!part.empty() && part.back() >= '0' && part.back() <= '9') part.remove_suffix(1);
    if (part == wanted) return true;
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  return false;
}

/// On the fold, or one of a pair.
bool has_copies(const Garment& garment, const Piece& piece) {
  const auto other = [&](const Piece& each) { return &each != &piece && each.drawn_name == piece.drawn_name; };
  return piece.fold || std::ranges::any_of(garment.pieces, other);
}

class WearerSides {
 public:
  WearerSides(const Garment& garment, const SewnCorners& corners) : garment_(garment), seen_(garment.pieces.size()) {
    for (const Wear& wear : garment.wears) {
      if (limb_side(wear.line) == 0 && !wear.line.empty()) see(wear, corners);
    }
    const std::vector<std::vector<Sighting>> worn = seen_;
    for (const std::vector<Sighting>& piece : worn) worn_.push_back(!piece.empty());
    for (const Seam& seam : garment.seams) {
      if (seam.is_dart || seam.is_pleat || seam.open || is_sewn_upon(seam, garment.pieces)) continue;
      carry(seam.first, seam.second, worn);
      carry(seam.second, seam.first, worn);
    }
  }

  /// By how much a line that is worn lies round the body from where the names of its pieces say: as a fraction of a
  /// turn.
  std::optional<double> off_by_names() const {
    Heading sum;
    double fronts = 0, backs = 0;
    for (std::size_t p = 0; p < seen_.size(); ++p) {
      const std::string& name = garment_.pieces[p].drawn_name;
      const bool front = has_word(name, "front"), back = has_word(name, "back");
      if (front == back) continue;
      for (const Sighting& each : seen_[p]) sum += front ? heading(each.fraction) : -heading(each.fraction);
      (front ? fronts : backs) += static_cast<double>(seen_[p].size());
    }
    if (fronts == 0 || backs == 0 || std::abs(sum) < clear_direction * (fronts + backs)) return std::nullopt;
    return std::arg(sum) / (2 * std::numbers::pi);
  }

  /// The body turns a ring so that its armholes lie at the arms.
  void turn_by(double fraction) {
    for (std::vector<Sighting>& piece : seen_) {
      for (Sighting& each : piece) each.fraction += fraction;
    }
  }

  bool knows(PieceId piece) const { return !seen_[piece].empty(); }
  bool is_worn(PieceId piece) const { return worn_[piece]; }

  /// The direction of a copy of a piece, times how clear it is.
  Heading of(const ChainLink& link) const {
    const Piece& piece = garment_.pieces[link.edge.piece];
    const std::vector<Sighting>& seen = seen_[link.edge.piece];
    if (seen.empty()) return {};
    if (!has_copies(garment_, piece)) {
      const std::optional<double> fraction = fraction_at(seen, place_at(piece.edge(link.edge.edge).curve, 0.5));
      return fraction ? heading(*fraction) : Heading{};
    }
    Heading sum;
    double count = 0;
    for (const Sighting& each : seen) {
      if (each.side != piece.edge(link.edge.edge).side) continue;
      sum += heading(each.fraction);
      ++count;
    }
    return count > 0 ? sum / count : Heading{};
  }

 private:
  /// Between the places that lie farthest round, evenly; none where these are one.
  static std::optional<double> fraction_at(const std::vector<Sighting>& seen, Vec2 place) {
    const auto [low, high] = std::ranges::minmax_element(seen, {}, &Sighting::fraction);
    const Vec2 way = high->at - low->at;
    if (norm(way) < least_spread) return std::nullopt;
    const double t = std::clamp(dot(place - low->at, way) / dot(way, way), 0.0, 1.0);
    return low->fraction + t * (high->fraction - low->fraction);
  }

  void add(const ChainLink& link, double along, double fraction) {
    const PieceEdge& edge = garment_.pieces[link.edge.piece].edge(link.edge.edge);
    const Vec2 at = place_at(edge.curve, link.forward ? along : 1 - along);
    seen_[link.edge.piece].push_back({at, edge.side, fraction});
  }

  /// Walked with its cloth on the left, what hangs down runs from the wearer's left over the front to the right.
  void see(const Wear& wear, const SewnCorners& corners) {
    const double whole = length(garment_.pieces, wear.chain);
    double forwards = 0, before = 0;
    for (const ChainLink& link : wear.chain) {
      if (garment_.pieces[link.edge.piece].is_inside(link.edge.edge)) return;
      forwards += (link.forward ? 1 : -1) * length(garment_.pieces, {link});
    }
    const bool closed = corners.end(wear.chain.back()) == corners.start(wear.chain.front());
    const double centre = worn_centre(garment_.pieces, wear.chain, closed), way = forwards > 0 ? -1 : 1;
    // Of a line that closes within a piece, what comes last runs on into what came first.
    std::size_t last = wear.chain.size();
    const auto on_first = [&](const ChainLink& link) { return link.edge.piece == wear.chain.front().edge.piece; };
    while (closed && last > 0 && on_first(wear.chain[last - 1])) --last;
    for (std::size_t l = 0; l < wear.chain.size(); ++l) {
      const double own = length(garment_.pieces, {wear.chain[l]}), round = l >= last && last > 0 ? whole : 0;
      for (int i = 0; i <= samples_of_edge; ++i) {
        const double along = static_cast<double>(i) / samples_of_edge;
        add(wear.chain[l], along, wear.from + way * (before + along * own - centre - round) / whole);
      }
      before += own;
    }
  }

  /// What is sewn to a piece that is worn, as a bodice to its collar, lies where that does.
  void carry(const Chain& from, const Chain& to, const std::vector<std::vector<Sighting>>& worn) {
    const auto known = [&](const ChainLink& link) { return !worn[link.edge.piece].empty(); };
    if (!std::ranges::all_of(from, known) || std::ranges::any_of(to, known)) return;
    const double first = length(garment_.pieces, from), second = length(garment_.pieces, to);
    double before = 0;
    for (const ChainLink& link : to) {
      const double own = length(garment_.pieces, {link});
      for (int i = 0; i <= samples_of_edge; ++i) {
        const double along = static_cast<double>(i) / samples_of_edge;
        const auto fraction = along_chain(from, (before + along * own) / second * first, worn);
        if (fraction) add(link, along, *fraction);
      }
      before += own;
    }
  }

  std::optional<double> along_chain(const Chain& chain, double s,
                                    const std::vector<std::vector<Sighting>>& worn) const {
    for (const ChainLink& link : chain) {
      const Curve& curve = garment_.pieces[link.edge.piece].edge(link.edge.edge).curve;
      const double own = curve.length();
      if (s > own && &link != &chain.back()) {
        s -= own;
        continue;
      }
      const double along = std::clamp(s / own, 0.0, 1.0);
      return fraction_at(worn[link.edge.piece], place_at(curve, link.forward ? along : 1 - along));
    }
    return std::nullopt;
  }

  const Garment& garment_;
  std::vector<std::vector<Sighting>> seen_;  // by piece
  std::vector<bool> worn_;                   // by piece: at a line of the trunk
};

std::string worn_name(const Garment& garment, const ChainLink& link) {
  const Piece& piece = garment.pieces[link.edge.piece];
  const PieceEdge& edge = piece.edge(link.edge.edge);
  const char* copy = edge.side == Side::Mirrored ? ".mirrored" : ".drawn";
  return piece.drawn_name + "." + edge.name + (has_copies(garment, piece) ? copy : "");
}

/// What a worn line is sewn to: the piece's own place where that is known, else its neighbours'.
struct SideEvidence {
  Heading sum;
  double length = 0;
  const Seam* seam = nullptr;
  ChainLink link;  // that says it
};

class WornSidesCheck {
 public:
  WornSidesCheck(const DraftGarment& draft, const Garment& garment, const SewnCorners& corners, Findings& findings)
      : draft_(draft), garment_(garment), findings_(findings), sides_(garment, corners) {
    for (const Seam& seam : garment.seams) {
      for (const Chain* chain : {&seam.first, &seam.second}) {
        for (const ChainLink& link : *chain) sewn_.insert(link_key(link));
      }
    }
  }

  void check() {
    const auto on_arm = [](const Wear& wear) { return wear.line.ends_with("_armhole"); };
    const bool turned = std::ranges::any_of(garment_.wears, on_arm);
    if (const std::optional<double> off = sides_.off_by_names()) {
      if (turned) {
        sides_.turn_by(-*off);
      } else if (std::abs(*off) > back_to_front) {
        return report_back_in_front();
      }
    }
    std::set<std::string> told;  // of a left and a right one that are exchanged the first is told
    for (std::size_t w = 0; w < garment_.wears.size(); ++w) {
      const Wear& wear = garment_.wears[w];
      const int side = limb_side(wear.line);
      if (side == 0) continue;
      const std::string limb = wear.line.substr(wear.line.find('_') + 1);
      if (told.contains(limb)) continue;
      const SideEvidence evidence = evidence_of(wear);
      const double across = evidence.length > 0 ? evidence.sum.imag() / evidence.length : 0;
      if (across * side < -clear_direction) {
        report(draft_.wears[w], wear, side, evidence);
        told.insert(limb);
      } else if (report_unsewn(wear)) {
        told.insert(limb);
      }
    }
  }

 private:
  SideEvidence evidence_of(const Wear& wear) const {
    SideEvidence evidence;
    const auto count = [&](const ChainLink& link, const Seam* seam) {
      if (!sides_.knows(link.edge.piece)) return;
      const double own = length(garment_.pieces, {link});
      const Heading turn = sides_.of(link);
      // Both legs have a part in the crotch seam. The one meant is that of the front.
      if (wear.line.ends_with("_crotch") && turn.real() < 0) return;
      if (evidence.length == 0) evidence.seam = seam, evidence.link = link;
      evidence.sum += own * turn;
      evidence.length += own;
    };
    for (const ChainLink& link : wear.chain) {
      if (sides_.is_worn(link.edge.piece)) count(link, nullptr);
      if (sides_.is_worn(link.edge.piece)) continue;
      for (const Seam& seam : garment_.seams) {
        const auto has = [&](const Chain& chain) {
          return std::ranges::any_of(chain, [&](const ChainLink& each) { return link_key(each) == link_key(link); });
        };
        if (has(seam.first)) std::ranges::for_each(seam.second, [&](const ChainLink& other) { count(other, &seam); });
        if (has(seam.second)) std::ranges::for_each(seam.first, [&](const ChainLink& other) { count(other, &seam); });
      }
    }
    return evidence;
  }

  /// Copies exchanged where the script names copies, else the other line.
  std::string remedy(const DraftWear& draft, const Wear& wear, int side) const {
    const std::string limb = wear.line.substr(wear.line.find('_') + 1);
    const auto stated = [](const DraftEdgeRef& each) { return each.side.has_value(); };
    if (!std::ranges::all_of(draft.chain, stated)) {
      return fmt::format("wear it at `{}_{}`", side_word(-side), limb);
    }
    std::string chain;
    for (const DraftEdgeRef& each : draft.chain) {
      chain += fmt::format("{}{}.{}.{}", chain.empty() ? "" : " + ", each.piece, each.edge,
                           each.side == Side::Mirrored ? "drawn" : "mirrored");
    }
    return fmt::format("wear `{}` at `{}`, and this at `{}_{}`", chain, wear.line, side_word(-side), limb);
  }

  void report(const DraftWear& draft, const Wear& wear, int side, const SideEvidence& evidence) {
    const std::string worn = worn_name(garment_, evidence.seam == nullptr ? evidence.link : wear.chain.front());
    const Piece& piece = garment_.pieces[evidence.link.edge.piece];
    std::vector<Label> labels{{wear.written, fmt::format("worn at the {}", side_word(side))}};
    const PieceEdge& edge = piece.edge(evidence.link.edge.edge);
    labels.push_back({evidence.seam == nullptr ? edge.written : evidence.seam->written,
                      evidence.seam == nullptr
                          ? fmt::format("this part of `{}` lies at the {}", piece.drawn_name, side_word(-side))
                          : fmt::format("sewn to {}, which lies at the {}", quoted(worn_name(garment_, evidence.link)),
                                        side_word(-side))});
    findings_.warning(
        "W0341",
        fmt::format("{} is worn at `{}`, and belongs to the wearer's {}", quoted(worn), wear.line, side_word(-side)),
        std::move(labels), remedy(draft, wear, side));
  }

  /// One copy of a piece is sewn there, the other one to nothing.
  bool report_unsewn(const Wear& wear) {
    for (const ChainLink& link : wear.chain) {
      if (sewn_.contains(link_key(link))) continue;
      const Piece& piece = garment_.pieces[link.edge.piece];
      const PieceEdge& edge = piece.edge(link.edge.edge);
      for (std::size_t p = 0; p < garment_.pieces.size(); ++p) {
        const Piece& other = garment_.pieces[p];
        if (other.drawn_name != piece.drawn_name) continue;
        for (int e = 0; e < other.edge_count(); ++e) {
          const bool copy = other.edge(e).name == edge.name && other.edge(e).side != edge.side;
          if (!copy || !sewn_.contains({static_cast<int>(p), e})) continue;
          findings_.warning(
              "W0341",
              fmt::format("{} is worn at `{}` and sewn to nothing, and its other copy is sewn",
                          quoted(worn_name(garment_, link)), wear.line),
              {{wear.written, "worn here"}, {edge.written, "the edge"}},
              fmt::format("sew it, too: `sew {}.{} to ...` without `.drawn` and `.mirrored` sews both copies",
                          piece.drawn_name, edge.name));
          return true;
        }
      }
    }
    return false;
  }

  void report_back_in_front() {
    for (const Wear& wear : garment_.wears) {
      if (limb_side(wear.line) != 0) continue;
      findings_.warning("W0341", fmt::format("the back is worn in front at `{}`", wear.line),
                        {{wear.written, "the middle of the edge named first comes to the front"}},
                        "name an edge of the front first, or turn the line by half of its girth: `from 50%`");
      return;
    }
  }

  const DraftGarment& draft_;
  const Garment& garment_;
  Findings& findings_;
  WearerSides sides_;
  std::set<LinkKey> sewn_;
};

}  // namespace

void check_worn_sides(const DraftGarment& draft, const Garment& garment, const SewnCorners& corners,
                      Findings& findings) {
  if (garment.drawn_on.empty()) WornSidesCheck(draft, garment, corners, findings).check();
}

}  // namespace toile
