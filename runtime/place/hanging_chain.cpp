#include "runtime/place/hanging_chain.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace toile {
namespace {

bool lies_on(const SewnMesh& mesh, int vertex, PieceId piece) {
  const auto& corners = mesh.s.p_of_s[vertex];
  return std::any_of(corners.begin(), corners.end(), [&](int p) { return mesh.p.piece_of_point[p] == piece; });
}

// The arc length at the middle of the first edge: of the run of vertices around the chain's start on its first piece.
double middle_of_first_edge(const SewnMesh& mesh, const SMesh::WornLine& line) {
  const int n = static_cast<int>(line.vertices.size());
  PieceId piece = 0;
  for (const int p : mesh.s.p_of_s[line.vertices[0]]) {
    piece = mesh.p.piece_of_point[p];
    if (n < 2 || lies_on(mesh, line.vertices[1], piece)) break;
  }
  int last = 0;
  while (last + 1 < n && lies_on(mesh, line.vertices[last + 1], piece)) ++last;
  if (last == n - 1) return 0.5 * (line.closed ? line.length : line.arc[last]);
  int before = 0;
  while (line.closed && before + 1 < n - last && lies_on(mesh, line.vertices[n - 1 - before], piece)) ++before;
  const double first_arc = before > 0 ? line.arc[n - before] - line.length : line.arc[0];
  return 0.5 * (first_arc + line.arc[last]);
}

// +1 when the chain is to run counter-clockwise. A triangle of the right side that walks the chain's way has its cloth
// on the left: hanging down and seen from outside, it walks clockwise.
double sense(const SewnMesh& mesh, const SMesh::WornLine& line) {
  const std::size_t n = line.vertices.size();
  std::vector<bool> on_chain(static_cast<std::size_t>(mesh.s.vertex_count), false);
  for (const int v : line.vertices) on_chain[v] = true;
  std::set<std::pair<int, int>> walks;
  for (const auto& t : mesh.s.triangles) {
    for (int c = 0; c < 3; ++c) {
      if (on_chain[t[c]] && on_chain[t[(c + 1) % 3]]) walks.emplace(t[c], t[(c + 1) % 3]);
    }
  }
  int with = 0, against = 0;
  for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
    const int a = line.vertices[i], b = line.vertices[(i + 1) % n];
    with += walks.contains({a, b});
    against += walks.contains({b, a});
  }
  return with > against ? -1 : 1;
}

}  // namespace

HangingChain hang(const SewnMesh& mesh, const Worn& worn, const BodyLine& line) {
  const SMesh::WornLine& chain = *worn.line;
  const std::size_t n = chain.vertices.size();
  // An open chain that goes all the way round keeps its ends apart.
  const double needed = chain.closed ? chain.length : chain.length * (1 + 1.0 / static_cast<double>(n));
  HangingChain result{chain.vertices, {}, scaled(line, needed), {}};
  const double middle = middle_of_first_edge(mesh, chain);
  const double turn = sense(mesh, chain) / (chain.closed ? chain.length : result.curve.length());
  for (std::size_t i = 0; i < n; ++i) {
    result.fractions.push_back(worn.from + turn * (chain.arc[i] - middle));
    result.positions.push_back(result.curve.at(result.fractions.back()));
  }
  return result;
}

}  // namespace toile
