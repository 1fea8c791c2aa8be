// Worn lines: edges lined up so that they run on continuously once the garment is sewn.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

std::vector<Strand> strands_of(const std::vector<FoundEdge>& edges, const SewnCorners& corners) {
  std::vector<Strand> strands;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const int reference = static_cast<int>(i);
    if (edges[i].free()) {
      for (Strand& copy : both_copies(edges[i], reference, true, corners)) strands.push_back(std::move(copy));
    } else {
      const Side side = edges[i].written->side.value_or(Side::Drawn);
      strands.push_back({reference, side, *edges[i].copies[static_cast<std::size_t>(side)]});
    }
  }
  return strands;
}

void report_break(const DraftWear& draft, const std::vector<FoundEdge>& edges, const LinedUp& lined_up,
                  const std::optional<TwistedSeam>& twist, Findings& findings) {
  const Strand& rest = lined_up.left_over.front();
  const Strand& last = lined_up.strands.back();
  const FoundEdge& loose = edges[rest.reference];
  const FoundEdge& end = edges[last.reference];
  const auto name = [](const FoundEdge& edge, Side side) { return quoted(edge_name(edge, side)); };
  std::vector<Label> labels{{loose.written->written, "no seam joins this edge to the others"},
                            {end.written->written, "the line ends here"},
                            {draft.written, "the worn line"}};
  std::string help =
      "sew the edges beside them, name one copy alone (`piece.edge.mirrored`), or write a `wear` for each line";
  if (twist) {
    labels.push_back({twist->written, "this seam is twisted"});
    help = twist->reversed ? "leave out `reversed`: start to start the seam turns a piece upside down" : twist->remedy;
  }
  findings.error("E0319",
                 fmt::format("the worn line is not continuous once sewn: {} does not run on into {}",
                             name(end, last.side), name(loose, rest.side)),
                 std::move(labels), std::move(help));
}

/// Parts of an edge between darts, and its mirrored copy.
bool same_drawn_edge(const std::vector<Piece>& pieces, const ChainLink& a, const ChainLink& b) {
  const Piece &first = pieces[a.edge.piece], &second = pieces[b.edge.piece];
  return first.drawn_name == second.drawn_name && first.edge(a.edge.edge).name == second.edge(b.edge.edge).name;
}

}  // namespace

double worn_centre(const std::vector<Piece>& pieces, const Chain& chain, bool closed) {
  double before = 0, after = 0;
  std::size_t count = 0;
  while (count < chain.size() && same_drawn_edge(pieces, chain[0], chain[count])) {
    after += length(pieces, {chain[count++]});
  }
  for (std::size_t i = chain.size(); closed && i > count && same_drawn_edge(pieces, chain[0], chain[i - 1]); --i) {
    before += length(pieces, {chain[i - 1]});
  }
  return (after - before) / 2;
}

std::vector<Wear> resolve_wears(const DraftGarment& draft, const std::vector<Piece>& pieces,
                                const std::vector<std::vector<Seam>>& seams, const SewnCorners& corners, bool complete,
                                Findings& findings) {
  const EdgeFinder finder(draft, pieces);
  std::vector<Wear> wears;
  for (const DraftWear& wear : draft.wears) {
    const std::optional<std::vector<FoundEdge>> edges = finder.find(wear.chain, "worn", findings);
    if (!edges || !std::all_of(edges->begin(), edges->end(), [](const FoundEdge& e) { return e.cut(); })) continue;
    LinedUp lined_up = line_up(strands_of(*edges, corners), false, corners);
    if (!lined_up.left_over.empty() && complete) {
      const PieceId last = lined_up.strands.back().links.back().edge.piece;
      const PieceId rest = lined_up.left_over.front().links.front().edge.piece;
      report_break(wear, *edges, lined_up, find_twist(draft, seams, pieces, last, rest), findings);
    }
    wears.push_back({joined(lined_up.strands), wear.line, wear.held, wear.from, wear.written});
  }
  return wears;
}

void check_worn_once(const std::vector<Wear>& wears, const std::vector<Piece>& pieces, Findings& findings) {
  std::map<std::pair<int, int>, Location> worn;
  for (const Wear& wear : wears) {
    for (const ChainLink& link : wear.chain) {
      const auto [before, fresh] = worn.insert({{link.edge.piece, link.edge.edge}, wear.written});
      if (fresh) continue;
      const Piece& piece = pieces[link.edge.piece];
      const PieceEdge& edge = piece.edge(link.edge.edge);
      findings.error(
          "E0318", fmt::format("edge {} is worn twice", quoted(piece.drawn_name + "." + edge.name)),
          {{wear.written, "the second time"}, {before->second, "the first time"}, {edge.written, "the edge"}},
          edge.side == Side::Mirrored
              ? fmt::format(
                    "without a side both copies are meant: write `{0}.{1}.drawn` for the one and `{0}.{1}.mirrored` "
                    "for the other",
                    piece.drawn_name, edge.name)
              : "an edge is worn at one line of the body");
      break;
    }
  }
}

}  // namespace toile
