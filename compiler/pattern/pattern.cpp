#include "compiler/pattern/pattern.hpp"

namespace toile {
namespace {

/// The loop or line on which an edge lies, and the number of its first edge.
struct PlaceOnWalk {
  const std::vector<PieceEdge>& walk;
  int first;
  bool is_line;
};

PlaceOnWalk place_of(const Piece& piece, int number) {
  int first = 0;
  const std::vector<PieceEdge>* walk = &piece.edges;
  const auto passed = [&] {
    const int end = first + static_cast<int>(walk->size());
    if (number < end) return false;
    first = end;
    return true;
  };
  if (!passed()) return {*walk, first, false};
  for (const auto& hole : piece.holes) {
    walk = &hole;
    if (!passed()) return {*walk, first, false};
  }
  for (const auto& line : piece.lines) {
    walk = &line;
    if (!passed()) return {*walk, first, true};
  }
  return {*walk, first, !piece.lines.empty()};
}

}  // namespace

int Piece::edge_count() const {
  std::size_t count = edges.size();
  for (const auto& hole : holes) count += hole.size();
  for (const auto& line : lines) count += line.size();
  return static_cast<int>(count);
}

const PieceEdge& Piece::edge(int number) const {
  const PlaceOnWalk place = place_of(*this, number);
  return place.walk[number - place.first];
}

PieceEdge& Piece::edge(int number) {
  return const_cast<PieceEdge&>(static_cast<const Piece&>(*this).edge(number));
}

int Piece::next_edge(int number) const {
  const PlaceOnWalk place = place_of(*this, number);
  const int next = number - place.first + 1, count = static_cast<int>(place.walk.size());
  if (place.is_line && next == count) return -1;
  return place.first + next % count;
}

bool Piece::is_inside(int number) const {
  return !lines.empty() && place_of(*this, number).is_line;
}

}  // namespace toile
