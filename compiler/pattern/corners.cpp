#include <cmath>
#include <numeric>

#include "compiler/pattern/sewing.hpp"

namespace toile {

Chain reversed(const Chain& chain) {
  Chain backwards(chain.rbegin(), chain.rend());
  for (ChainLink& link : backwards) link.forward = !link.forward;
  return backwards;
}

double length(const std::vector<Piece>& pieces, const Chain& chain) {
  double sum = 0;
  for (const ChainLink& link : chain) sum += pieces[link.edge.piece].edge(link.edge.edge).curve.length();
  return sum;
}

SewnCorners::SewnCorners(const std::vector<Piece>& pieces) : pieces_(pieces) {
  int corners = 0;
  for (const Piece& piece : pieces) {
    first_corner_.push_back(corners);
    corners += piece.edge_count() + static_cast<int>(piece.lines.size());
  }
  parent_.resize(corners);
  std::iota(parent_.begin(), parent_.end(), 0);
  same_corner_ = parent_;
  unite_lines_with_outlines();
}

void SewnCorners::unite_lines_with_outlines() {
  constexpr double kSameCorner = 2e-6;  // [m]
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    if (piece.lines.empty()) continue;
    std::vector<Vec2> places;
    for (int e = 0; e < piece.edge_count(); ++e) places.push_back(piece.edge(e).curve.start());
    for (const auto& line : piece.lines) places.push_back(line.back().curve.end());
    for (std::size_t later = 1; later < places.size(); ++later) {
      for (std::size_t earlier = 0; earlier < later; ++earlier) {
        if (distance(places[earlier], places[later]) > kSameCorner) continue;
        same_corner_[first_corner_[p] + later] = first_corner_[p] + static_cast<int>(earlier);
        break;
      }
    }
  }
}

int SewnCorners::find(int corner) const {
  while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
  return corner;
}

void SewnCorners::unite(int a, int b) {
  parent_[find(a)] = find(b);
}

int SewnCorners::corner_at_start(const ChainLink& link) const {
  const Piece& piece = pieces_[link.edge.piece];
  int corner = link.forward ? link.edge.edge : piece.next_edge(link.edge.edge);
  if (corner < 0) {  // the end of a line
    corner = piece.edge_count();
    int first = corner;
    for (std::size_t line = piece.lines.size(); line-- > 0;) {
      first -= static_cast<int>(piece.lines[line].size());
      if (link.edge.edge < first) continue;
      corner += static_cast<int>(line);
      break;
    }
  }
  return same_corner_[first_corner_[link.edge.piece] + corner];
}

int SewnCorners::start(const ChainLink& link) const {
  return find(corner_at_start(link));
}

int SewnCorners::end(const ChainLink& link) const {
  return start({link.edge, !link.forward});
}

bool SewnCorners::adjacent(const ChainLink& link, const ChainLink& next) const {
  return corner_at_start({link.edge, !link.forward}) == corner_at_start(next);
}

void SewnCorners::sew(const Seam& seam) {
  unite(start(seam.first.front()), start(seam.second.front()));
  unite(end(seam.first.back()), end(seam.second.back()));
  const double first_length = length(pieces_, seam.first), second_length = length(pieces_, seam.second);
  double first_reached = 0;
  for (const ChainLink& link : seam.first) {
    first_reached += length(pieces_, {link}) / first_length;
    double second_reached = 0;
    for (const ChainLink& other : seam.second) {
      second_reached += length(pieces_, {other}) / second_length;
      if (std::abs(first_reached - second_reached) < 1e-6) unite(end(link), end(other));
    }
  }
}

}  // namespace toile
