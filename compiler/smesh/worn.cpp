#include "compiler/smesh/worn.hpp"

#include <algorithm>

namespace toile {
namespace {

/// Parts of an edge between darts, and its mirrored copy.
bool same_drawn_edge(const Garment& garment, const ChainLink& a, const ChainLink& b) {
  const Piece &first = garment.pieces[a.edge.piece], &second = garment.pieces[b.edge.piece];
  return first.drawn_name == second.drawn_name && first.edge(a.edge.edge).name == second.edge(b.edge.edge).name;
}

double centre_of(const Garment& garment, const Chain& chain, bool closed) {
  const auto length = [&](const ChainLink& link) {
    return garment.pieces[link.edge.piece].edge(link.edge.edge).curve.length();
  };
  double before = 0, after = 0;
  std::size_t count = 0;
  while (count < chain.size() && same_drawn_edge(garment, chain[0], chain[count])) after += length(chain[count++]);
  for (std::size_t i = chain.size(); closed && i > count && same_drawn_edge(garment, chain[0], chain[i - 1]); --i) {
    before += length(chain[i - 1]);
  }
  return (after - before) / 2;
}

}  // namespace

std::vector<SMesh::WornLine> find_worn_lines(const Garment& garment, const PMesh& p, const SMesh& s) {
  std::vector<SMesh::WornLine> lines;
  for (int w = 0; w < static_cast<int>(garment.wears.size()); ++w) {
    SMesh::WornLine line;
    line.wear = w;
    int last = -1;
    for (const ChainLink& link : garment.wears[w].chain) {
      const PMesh::EdgeNodes& nodes = p.edge_nodes[link.edge.piece][link.edge.edge];
      const int n = static_cast<int>(nodes.points.size());
      const double length = nodes.arc.back();
      for (int i = 0; i < n; ++i) {
        const int k = link.forward ? i : n - 1 - i;
        last = s.s_of_p[nodes.points[k]];
        if (std::find(line.vertices.begin(), line.vertices.end(), last) != line.vertices.end()) continue;
        line.vertices.push_back(last);
        line.arc.push_back(line.length + (link.forward ? nodes.arc[k] : length - nodes.arc[k]));
      }
      line.length += length;
      line.pieces.push_back(link.edge.piece);
    }
    std::sort(line.pieces.begin(), line.pieces.end());
    line.pieces.erase(std::unique(line.pieces.begin(), line.pieces.end()), line.pieces.end());
    line.closed = line.vertices.size() > 2 && last == line.vertices.front();
    line.centre = centre_of(garment, garment.wears[w].chain, line.closed);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace toile
