// Lining up edges so that they run on continuously in the sewn garment.
#include <algorithm>

#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

Strand turned(Strand strand) {
  strand.links = reversed(strand.links);
  return strand;
}

// A row of strands that grows at both ends.
class Row {
 public:
  Row(Strand first, const SewnCorners& corners) : strands_{std::move(first)}, corners_(corners) {}

  // Joins one of the waiting strands on if any fits. To keep the direction comes before turning one round, which only a
  // surface with one side asks for; going on forwards comes before going on backwards.
  std::optional<std::size_t> grow(const std::vector<Strand>& waiting) {
    for (const bool turn : {false, true}) {
      for (const bool forwards : {true, false}) {
        for (std::size_t i = 0; i < waiting.size(); ++i) {
          const Strand strand = turn ? turned(waiting[i]) : waiting[i];
          if (forwards && start(strand) == end(strands_.back())) {
            strands_.push_back(strand);
            return i;
          }
          if (!forwards && end(strand) == start(strands_.front())) {
            strands_.insert(strands_.begin(), strand);
            return i;
          }
        }
      }
    }
    return std::nullopt;
  }

  std::vector<Strand> take() { return std::move(strands_); }

 private:
  int start(const Strand& strand) const { return corners_.start(strand.links.front()); }
  int end(const Strand& strand) const { return corners_.end(strand.links.back()); }

  std::vector<Strand> strands_;
  const SewnCorners& corners_;
};

}  // namespace

LinedUp line_up(const std::vector<Strand>& strands, bool one_of_each, const SewnCorners& corners) {
  std::vector<Strand> waiting = strands;
  const auto drop = [&](std::size_t i) {
    const int reference = waiting[i].reference;
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(i));
    if (one_of_each) std::erase_if(waiting, [&](const Strand& s) { return s.reference == reference; });
  };
  Row row(waiting.front(), corners);
  drop(0);
  while (!waiting.empty()) {
    const std::optional<std::size_t> joined_on = row.grow(waiting);
    if (!joined_on) break;
    drop(*joined_on);
  }
  return {row.take(), waiting};
}

Chain joined(const std::vector<Strand>& strands) {
  Chain chain;
  for (const Strand& strand : strands) chain.insert(chain.end(), strand.links.begin(), strand.links.end());
  return chain;
}

std::vector<Strand> both_copies(const FoundEdge& edge, int reference, bool cloth_on_left, const SewnCorners& corners) {
  const auto copy = [&](Side side) {
    const Chain& links = *edge.copies[static_cast<std::size_t>(side)];
    return Strand{reference, side, cloth_on_left ? links : reversed(links)};
  };
  const Strand drawn = copy(Side::Drawn), mirrored = copy(Side::Mirrored);
  // Over the fold, or else through a seam; where both ends meet through seams the mirrored copy leads.
  if (corners.adjacent(mirrored.links.back(), drawn.links.front())) return {mirrored, drawn};
  if (corners.adjacent(drawn.links.back(), mirrored.links.front())) return {drawn, mirrored};
  if (corners.end(mirrored.links.back()) == corners.start(drawn.links.front())) return {mirrored, drawn};
  return {drawn, mirrored};
}

std::string edge_name(const FoundEdge& edge, std::optional<Side> side) {
  std::string name = edge.written->piece + "." + edge.written->edge;
  if (side == Side::Mirrored) name += ".mirrored";
  if (edge.written->part)
    name += " in " + script_cm(edge.written->part->from) + ".." + script_cm(edge.written->part->to);
  return name;
}

}  // namespace toile
