#include "compiler/pattern/pattern.hpp"

namespace toile {
namespace {

/// The loop on which an edge lies, and the number of the loop's first edge.
struct PlaceOnLoop {
  const std::vector<PieceEdge>& loop;
  int first;
};

PlaceOnLoop place_of(const Piece& piece, int number) {
  const auto size = [](const std::vector<PieceEdge>& loop) { return static_cast<int>(loop.size()); };
  int first = size(piece.edges);
  if (number < first) return {piece.edges, 0};
  std::size_t hole = 0;
  while (hole + 1 < piece.holes.size() && number >= first + size(piece.holes[hole])) first += size(piece.holes[hole++]);
  return {piece.holes[hole], first};
}

}  // namespace

int Piece::edge_count() const {
  std::size_t count = edges.size();
  for (const auto& hole : holes) count += hole.size();
  return static_cast<int>(count);
}

const PieceEdge& Piece::edge(int number) const {
  const PlaceOnLoop place = place_of(*this, number);
  return place.loop[number - place.first];
}

PieceEdge& Piece::edge(int number) {
  return const_cast<PieceEdge&>(static_cast<const Piece&>(*this).edge(number));
}

int Piece::next_edge(int number) const {
  const PlaceOnLoop place = place_of(*this, number);
  return place.first + (number - place.first + 1) % static_cast<int>(place.loop.size());
}

}  // namespace toile
