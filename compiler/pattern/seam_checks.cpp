// What can be wrong with seams once their edges are known.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

constexpr double kSeamTolerance = 0.5e-3;    // [m]
constexpr double kRelativeTolerance = 1e-3;  // of the longer side
constexpr double kBareEase = 0.1;            // of the longer side, for `ease` and `stretch` without an amount

using EdgeKey = std::pair<int, int>;

EdgeKey key(const ChainLink& link) {
  return {link.edge.piece, link.edge.edge};
}

std::string name_of(const std::vector<Piece>& pieces, const ChainLink& link) {
  const PieceEdge& edge = pieces[link.edge.piece].edge(link.edge.edge);
  return quoted(pieces[link.edge.piece].drawn_name + "." + edge.name +
                (edge.side == Side::Mirrored ? ".mirrored" : ""));
}

Location edge_written(const std::vector<Piece>& pieces, const ChainLink& link) {
  return pieces[link.edge.piece].edge(link.edge.edge).written;
}

std::set<EdgeKey> keys(const Chain& chain) {
  std::set<EdgeKey> found;
  for (const ChainLink& link : chain) found.insert(key(link));
  return found;
}

bool glued_onto_itself(const Seam& seam) {
  return std::equal(seam.first.begin(), seam.first.end(), seam.second.begin(), seam.second.end(),
                    [](const ChainLink& a, const ChainLink& b) { return a.edge == b.edge && a.forward == b.forward; });
}

const char* word(Seam::Fullness fullness) {
  switch (fullness) {
    case Seam::Fullness::Ease:
      return "ease";
    case Seam::Fullness::Gather:
      return "gather";
    case Seam::Fullness::Stretch:
      return "stretch";
    case Seam::Fullness::None:
      break;
  }
  return "";
}

std::string side_name(const std::vector<DraftEdgeRef>& references) {
  std::string name;
  for (const DraftEdgeRef& reference : references) {
    if (!name.empty()) name += " + ";
    name += reference.piece + "." + reference.edge + (reference.side == Side::Mirrored ? ".mirrored" : "");
  }
  return quoted(name);
}

// The difference of lengths that the script lets pass [m].
double allowed_difference(const DraftSeam& draft, double longer) {
  const double tolerance = std::max(kSeamTolerance, kRelativeTolerance * longer);
  if (draft.fullness == Seam::Fullness::None) return tolerance;
  if (draft.stated) return *draft.stated + tolerance;
  return draft.fullness == Seam::Fullness::Gather ? longer : kBareEase * longer;
}

// Whether there is anything of a stated difference, which is the most that there may be: a twentieth of it, or of more
// than a centimetre all but half a millimetre of a tenth.
bool keeps_word(const DraftSeam& draft, double difference) {
  return !draft.stated || difference >= std::max(0.05 * *draft.stated, 0.1 * *draft.stated - kSeamTolerance);
}

std::vector<Label> length_labels(const DraftSeam& draft, double first, double second) {
  const auto text = [](const std::vector<DraftEdgeRef>& side, double length) {
    return in_cm(length) + (side.size() > 1 ? " long together" : " long");
  };
  return {{draft.first.front().written, text(draft.first, first)},
          {draft.second.front().written, text(draft.second, second)}};
}

void add_drawn_edges(const DraftGarment& draft, const std::vector<DraftEdgeRef>& side, std::vector<Label>& labels) {
  for (const DraftEdgeRef& reference : side) {
    for (const DraftPiece& piece : draft.pieces) {
      if (piece.name != reference.piece) continue;
      const DraftEdge* edge = drafted_edge(piece, reference.edge);
      if (edge == nullptr) continue;
      labels.push_back(
          {edge->written, fmt::format("{} as drawn in {}", in_cm(edge->curve.length()), quoted(piece.name))});
    }
  }
}

// Whether one side is there twice, on the fold or cut in pairs, and the other once.
bool copies_differ(const DraftGarment& garment, const DraftSeam& draft) {
  const auto copied = [&](const DraftEdgeRef& reference) {
    const auto piece = std::find_if(garment.pieces.begin(), garment.pieces.end(),
                                    [&](const DraftPiece& each) { return each.name == reference.piece; });
    return piece != garment.pieces.end() && (piece->fold || piece->mirrored) && !reference.side;
  };
  return copied(draft.first.front()) != copied(draft.second.front());
}

std::string draft_reference(const DraftEdgeRef& reference) {
  return reference.piece + "." + reference.edge;
}

void report_lengths(const DraftGarment& garment, const DraftSeam& draft, double first, double second,
                    Findings& findings) {
  const double difference = std::abs(first - second);
  const std::string one = side_name(draft.first), other = side_name(draft.second);
  std::vector<Label> labels = length_labels(draft, first, second);
  add_drawn_edges(garment, draft.first, labels);
  add_drawn_edges(garment, draft.second, labels);
  const double shorter = std::min(first, second), tolerance = std::max(kSeamTolerance, kRelativeTolerance * shorter);
  if (std::abs(difference - shorter) < 2 * tolerance && copies_differ(garment, draft)) {
    findings.error(
        "E0316",
        fmt::format("seam lengths differ by {}: {} is {} long, {} is {}", in_cm(difference), one, in_cm(first), other,
                    in_cm(second)),
        std::move(labels),
        fmt::format("the longer side is there twice, drawn and mirrored: name one copy, `{}.drawn`, or cut the other "
                    "piece mirrored, too",
                    draft_reference(first < second ? draft.second.front() : draft.first.front())));
    return;
  }
  if (draft.fullness == Seam::Fullness::None) {
    findings.error("E0316",
                   fmt::format("seam lengths differ by {}: {} is {} long, {} is {}", in_cm(difference), one,
                               in_cm(first), other, in_cm(second)),
                   std::move(labels),
                   fmt::format("write `ease {}` if the longer one is to be eased in, or make {} {} longer",
                               script_cm(difference), first < second ? one : other, in_cm(difference)));
    return;
  }
  const bool more = keeps_word(draft, difference);
  const std::string stated = draft.stated ? in_cm(*draft.stated) : "10 % of the longer one";
  findings.error(
      "E0316",
      fmt::format("seam lengths differ by {}, {} than the {} of {}: {} is {} long, {} is {}", in_cm(difference),
                  more ? "more" : "less", word(draft.fullness), stated, one, in_cm(first), other, in_cm(second)),
      std::move(labels),
      !more && difference < tolerance ? fmt::format("leave `{}` out, or make one of them longer", word(draft.fullness))
                                      : fmt::format("write `{} {}`, or make {} longer", word(draft.fullness),
                                                    script_cm(difference), (first < second) == more ? one : other));
}

}  // namespace

std::set<std::size_t> check_sewn_once(const DraftGarment& draft, const std::vector<std::vector<Seam>>& seams,
                                      const std::vector<Piece>& pieces, Findings& findings) {
  std::set<std::size_t> second;
  std::map<EdgeKey, Location> sewn;
  std::set<std::pair<std::size_t, std::string>> reported;  // a piece's two copies fail together: say it once
  const auto report = [&](std::size_t i, const ChainLink& link, Location before) {
    const PieceEdge& edge = pieces[link.edge.piece].edge(link.edge.edge);
    second.insert(i);
    if (!reported.insert({i, pieces[link.edge.piece].drawn_name + "." + edge.name}).second) return;
    findings.error("E0317", fmt::format("edge {} is sewn twice", name_of(pieces, link)),
                   {{draft.seams[i].written, "the second seam"},
                    {before, "the first seam"},
                    {edge_written(pieces, link), "the edge"}},
                   "sew a part of it in each seam, `front.side in 0cm..18cm`, or all layers in one: `sew a to b to c`");
  };
  for (std::size_t i = 0; i < seams.size(); ++i) {
    for (const Seam& seam : seams[i]) {
      if (glued_onto_itself(seam)) {
        findings.error("E0321", fmt::format("edge {} would be glued onto itself", name_of(pieces, seam.first.front())),
                       {{seam.written, "each point would be sewn to itself"},
                        {edge_written(pieces, seam.first.front()), "the edge"}},
                       "leave out `reversed` to close the edge like a purse, or sew it to another edge");
        continue;
      }
      // A line sewn to itself end to start, like the mouth of a purse, names its edges on both sides.
      const bool purse = keys(seam.first) == keys(seam.second);
      for (const Chain* chain : {&seam.first, &seam.second}) {
        if (purse && chain == &seam.second) continue;
        if (seam.is_layer && chain == &seam.first) continue;
        for (const ChainLink& link : *chain) {
          const auto [before, fresh] = sewn.insert({key(link), seam.written});
          if (!fresh) report(i, link, before->second);
        }
      }
    }
  }
  return second;
}

void check_lengths(const DraftGarment& draft, const std::vector<std::vector<Seam>>& seams,
                   const std::vector<Piece>& pieces, const std::set<std::size_t>& told, Findings& findings) {
  const auto in_a_chart = [&](const Chain& chain) {
    return std::any_of(chain.begin(), chain.end(),
                       [&](const ChainLink& link) { return pieces[link.edge.piece].chart.has_value(); });
  };
  for (std::size_t i = 0; i < seams.size(); ++i) {
    if (told.contains(i)) continue;
    for (const Seam& seam : seams[i]) {
      if (in_a_chart(seam.first) || in_a_chart(seam.second)) continue;  // lengths come out of the development
      const double first = length(pieces, seam.first), second = length(pieces, seam.second);
      const double difference = std::abs(first - second);
      const bool within = difference <= allowed_difference(draft.seams[i], std::max(first, second));
      if (within && keeps_word(draft.seams[i], difference)) continue;
      report_lengths(draft, draft.seams[i], first, second, findings);
      break;
    }
  }
}

void check_ties(const DraftGarment& draft, const Garment& garment, Findings& findings) {
  const std::size_t count = garment.pieces.size();
  std::vector<std::size_t> group(count + 1);  // the last stands for the body
  std::iota(group.begin(), group.end(), 0);
  const auto tie = [&](std::size_t a, std::size_t b) {
    const std::size_t from = group[a], to = group[b];
    std::replace(group.begin(), group.end(), std::max(from, to), std::min(from, to));
  };
  for (const Seam& seam : garment.seams) {
    if (seam.open) continue;
    for (const Chain* chain : {&seam.first, &seam.second}) {
      for (const ChainLink& link : *chain) tie(link.edge.piece, seam.first.front().edge.piece);
    }
  }
  for (const Wear& wear : garment.wears) {
    for (const ChainLink& link : wear.chain) tie(link.edge.piece, count);
  }
  const std::size_t main = garment.wears.empty() ? group[0] : group[count];
  std::map<std::size_t, std::vector<std::size_t>> loose;
  for (std::size_t p = 0; p < count; ++p) {
    if (group[p] != main) loose[group[p]].push_back(p);
  }
  for (const auto& [representative, members] : loose) {
    std::vector<std::string> names;
    std::vector<Label> labels;
    for (const std::size_t p : members) {
      names.push_back(garment.pieces[p].name);
      labels.push_back({garment.pieces[p].written, "neither sewn to the rest nor worn"});
    }
    labels.push_back({draft.written, "the garment"});
    findings.error("E0320",
                   fmt::format("nothing ties {} {} to the rest of garment {}", members.size() > 1 ? "pieces" : "piece",
                               listed(names), quoted(draft.name)),
                   std::move(labels), "sew one of its edges to another piece, or `wear` it at a line of the body");
  }
}

}  // namespace toile
