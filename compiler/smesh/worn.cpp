#include "compiler/smesh/worn.hpp"

#include <algorithm>

#include "compiler/pattern/sewing.hpp"

namespace toile {

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
    line.centre = worn_centre(garment.pieces, garment.wears[w].chain, line.closed);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace toile
