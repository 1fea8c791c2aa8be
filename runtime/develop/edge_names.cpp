#include "runtime/develop/edge_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

std::string as_name(std::string text) {
  std::replace(text.begin(), text.end(), '.', '_');
  return text;
}

}  // namespace

EdgeNames::EdgeNames(const Garment& garment, bool halved) : garment_(garment) {
  for (const Piece& piece : garment.pieces) {
    pieces_.push_back(as_name(halved ? piece.drawn_name : piece.name));
    std::map<std::pair<std::string, Side>, int> parts;
    for (int e = 0; e < piece.edge_count(); ++e) ++parts[{piece.edge(e).name, piece.edge(e).side}];
    std::vector<std::string>& names = edges_.emplace_back();
    for (int e = 0; e < piece.edge_count(); ++e) {
      const PieceEdge& edge = piece.edge(e);
      std::string name = as_name(edge.name);
      if (parts[{edge.name, edge.side}] > 1) name += fmt::format("_{}", edge.part + 1);
      if (edge.side == Side::Mirrored && !halved) name += "_mirrored";
      names.push_back(std::move(name));
    }
  }
}

const std::string& EdgeNames::of(int piece, int edge) const {
  return edges_[index(piece)][index(edge)];
}

const std::string& EdgeNames::of_piece(int piece) const {
  return pieces_[index(piece)];
}

std::string EdgeNames::of_hole(std::size_t number) {
  return fmt::format("hole{}", number + 1);
}

std::string EdgeNames::reference(EdgeRef edge) const {
  const Piece& piece = garment_.pieces[index(edge.piece)];
  int first = static_cast<int>(piece.edges.size());
  for (std::size_t h = 0; h < piece.holes.size() && edge.edge >= first; ++h) {
    const int count = static_cast<int>(piece.holes[h].size());
    if (edge.edge < first + count) return of_hole(h) + "." + of(edge.piece, edge.edge);
    first += count;
  }
  return of(edge.piece, edge.edge);
}

}  // namespace toile
