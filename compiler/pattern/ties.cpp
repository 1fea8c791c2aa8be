// Places at which the two sides of a seam come to lie on each other: tied notches, and the ends of a stretch that takes
// all the fullness.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

constexpr double kAtEnd = 1e-6;  // [m]

// Places are told from where the edge named first begins as it is drawn, which may be the chain's other end.
class SeamPlaces {
 public:
  SeamPlaces(const Seam& seam, const std::vector<Piece>& pieces)
      : pieces_(pieces), chain_(seam.first), first_(length(pieces, seam.first)), second_(length(pieces, seam.second)) {
    const ChainLink& link = seam.first.front();
    turned_ = pieces[link.edge.piece].edge(link.edge.edge).against_drawing == link.forward;
  }

  double first_length() const { return first_; }
  double difference() const { return second_ - first_; }
  /// Along the first chain [m]; nothing when that is beyond its ends.
  std::optional<double> place(const DraftSeamPlace& at) const {
    if (!at.edge.empty()) return along_edge(at);
    const double s = at.is_fraction ? at.value * first_ : at.value;
    if (s < -kAtEnd || s > first_ + kAtEnd) return std::nullopt;
    const double inside = std::clamp(s, 0.0, first_);
    return turned_ ? first_ - inside : inside;
  }
  std::array<double, 2> ends() const { return {first_, second_}; }

 private:
  std::optional<double> along_edge(const DraftSeamPlace& at) const {
    double before = 0;
    for (const ChainLink& link : chain_) {
      const Piece& piece = pieces_[link.edge.piece];
      const PieceEdge& edge = piece.edge(link.edge.edge);
      const double whole = edge.curve.length(), drawn = edge.drawn.to - edge.drawn.from;
      const bool here = piece.drawn_name == at.piece && edge.name == at.edge && at.value > edge.drawn.from - kAtEnd &&
                        at.value < edge.drawn.to + kAtEnd;
      if (here && drawn > 0) {
        const double along = std::clamp((at.value - edge.drawn.from) / drawn, 0.0, 1.0) * whole;
        return before + (edge.against_drawing == link.forward ? whole - along : along);
      }
      before += whole;
    }
    return std::nullopt;
  }

  const std::vector<Piece>& pieces_;
  const Chain& chain_;
  double first_ = 0, second_ = 0;
  bool turned_ = false;
};

// Where a place of the first chain meets the second: alike in proportion between the ties around it.
double met(double s, const std::vector<std::array<double, 2>>& ties, std::array<double, 2> ends) {
  std::array<double, 2> before{0, 0}, after = ends;
  for (const auto& tie : ties) {
    if (tie[0] <= s) before = tie;
    if (tie[0] >= s) {
      after = tie;
      break;
    }
  }
  if (after[0] - before[0] < kAtEnd) return before[1];
  return before[1] + (s - before[0]) / (after[0] - before[0]) * (after[1] - before[1]);
}

void report(const DraftSeam& draft, const std::string& message, const std::string& label, const std::string& help,
            Findings& findings) {
  findings.error("E0334", message, {{draft.written, label}, {draft.first.front().written, "the line named first"}},
                 help);
}

bool add_taken(const DraftSeam& draft, const SeamPlaces& places, Seam& seam, Findings& findings) {
  std::optional<double> from = places.place(draft.taken->first), to = places.place(draft.taken->second);
  if (!from || !to) {
    report(draft, "the stretch for the fullness lies beyond the seam", in_cm(places.first_length()) + " long", "",
           findings);
    return false;
  }
  if (*from > *to) std::swap(from, to);
  const double stretch = *to - *from, other = stretch + places.difference();
  if (stretch < 1e-3 || other < 1e-3) {
    report(draft,
           fmt::format("a stretch of {} cannot take a difference of {}", in_cm(stretch),
                       in_cm(std::abs(places.difference()))),
           "", "make the stretch longer, or the difference smaller", findings);
    return false;
  }
  for (const auto& tie : {std::array{*from, *from}, std::array{*to, *to + places.difference()}}) {
    if (tie[0] > kAtEnd && tie[0] < places.first_length() - kAtEnd) seam.ties.push_back(tie);
  }
  return true;
}

}  // namespace

bool tie_places(const DraftSeam& draft, const std::vector<Piece>& pieces, Seam& seam, Findings& findings) {
  if (!draft.taken && draft.notches.empty()) return true;
  const SeamPlaces places(seam, pieces);
  if (draft.taken && !add_taken(draft, places, seam, findings)) return false;
  const std::vector<std::array<double, 2>> stretch = seam.ties;
  for (const DraftSeamPlace& notch : draft.notches) {
    const std::optional<double> s = places.place(notch);
    if (!s) {
      report(draft, "a notch lies beyond the seam", in_cm(places.first_length()) + " long", "", findings);
      return false;
    }
    seam.notches.push_back({*s, met(*s, stretch, places.ends())});
    if (*s > kAtEnd && *s < places.first_length() - kAtEnd) seam.ties.push_back(seam.notches.back());
  }
  const auto same = [](const auto& a, const auto& b) { return b[0] - a[0] < kAtEnd || b[1] - a[1] < kAtEnd; };
  std::sort(seam.ties.begin(), seam.ties.end());
  seam.ties.erase(std::unique(seam.ties.begin(), seam.ties.end(), same), seam.ties.end());
  return true;
}

void add_tied_notches(const std::vector<Seam>& seams, std::vector<Piece>& pieces) {
  for (const Seam& seam : seams) {
    for (const auto& pair : seam.notches) {
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const Chain& chain = side == 0 ? seam.first : seam.second;
        double rest = pair[side];
        for (const ChainLink& link : chain) {
          const double whole = length(pieces, {link});
          if (rest > whole + kAtEnd && &link != &chain.back()) {
            rest -= whole;
            continue;
          }
          const double along = std::clamp(rest, 0.0, whole);
          pieces[link.edge.piece].notches.push_back(
              {link.edge.edge, link.forward ? along : whole - along, seam.written});
          break;
        }
      }
    }
  }
}

}  // namespace toile
