// Places on the loops of a piece while it is being cut.
#include <algorithm>
#include <cmath>

#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

constexpr double kSamePlace = 1e-6;  // [m]

// A part's own length over what it takes of the edge as drawn: truing and slashing change the one, not the other.
double stretch_of(const PieceEdge& edge) {
  const double drawn = edge.drawn.to - edge.drawn.from;
  return drawn > 0 ? edge.curve.length() / drawn : 1;
}

}  // namespace

int DrawnPiece::number(int loop_index, int edge) const {
  for (int i = 0; i < loop_index; ++i) edge += static_cast<int>(loop(i).size());
  return edge;
}

std::optional<EdgePlace> find_place(const DrawnPiece& drawn, const std::string& edge, double at) {
  for (int l = 0; l < drawn.loop_count(); ++l) {
    const std::vector<PieceEdge>& loop = drawn.loop(l);
    for (int i = 0; i < static_cast<int>(loop.size()); ++i) {
      const PieceEdge& part = loop[i];
      if (part.is_dart_leg || part.name != edge) continue;
      if (at < part.drawn.from - kSamePlace || at > part.drawn.to + kSamePlace) continue;
      const double along = part.against_drawing ? part.drawn.to - at : at - part.drawn.from;
      return EdgePlace{l, i, std::clamp(along * stretch_of(part), 0.0, part.curve.length())};
    }
  }
  return std::nullopt;
}

double drawn_place(const DrawnPiece& drawn, const EdgePlace& place) {
  const PieceEdge& edge = drawn.loop(place.loop)[place.edge];
  const double along = place.s / stretch_of(edge);
  return edge.against_drawing ? edge.drawn.to - along : edge.drawn.from + along;
}

std::optional<EdgePlace> find_leg(const DrawnPiece& drawn, const std::string& name) {
  for (int l = 0; l < drawn.loop_count(); ++l) {
    const std::vector<PieceEdge>& loop = drawn.loop(l);
    for (int i = 0; i < static_cast<int>(loop.size()); ++i) {
      if (loop[i].is_dart_leg && loop[i].name == name) return EdgePlace{l, i, 0};
    }
  }
  return std::nullopt;
}

void divide_edge(DrawnPiece& drawn, const EdgePlace& place) {
  std::vector<PieceEdge>& loop = drawn.loop(place.loop);
  const double at = drawn_place(drawn, place);
  PieceEdge& first = loop[place.edge];
  PieceEdge second = first;
  second.curve = first.curve.part(place.s, first.curve.length());
  first.curve = first.curve.part(0, place.s);
  (first.against_drawing ? first.drawn.from : first.drawn.to) = at;
  (second.against_drawing ? second.drawn.to : second.drawn.from) = at;
  loop.insert(loop.begin() + place.edge + 1, std::move(second));
}

void divide_at(DrawnPiece& drawn, const std::string& edge, double at) {
  const std::optional<EdgePlace> place = find_place(drawn, edge, at);
  if (!place) return;
  const double length = drawn.loop(place->loop)[place->edge].curve.length();
  if (place->s > kSamePlace && place->s < length - kSamePlace) divide_edge(drawn, *place);
}

bool in_cloth(const DrawnPiece& drawn, Vec2 point) {
  if (!Region(drawn.piece.edges).contains(point)) return false;
  const auto& holes = drawn.piece.holes;
  return std::none_of(holes.begin(), holes.end(), [&](const auto& hole) { return Region(hole).contains(point); });
}

}  // namespace toile
