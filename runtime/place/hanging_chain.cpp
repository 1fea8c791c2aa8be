#include "runtime/place/hanging_chain.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace toile {
namespace {

// +1 when the chain is to run counter-clockwise. A triangle of the right side that walks the chain's way has its cloth
// on the left: hanging down and seen from outside, it walks clockwise. Of a chain that joins two pieces the one named
// hangs from it: of an armhole its sleeve.
double sense(const SewnMesh& mesh, const SMesh::WornLine& line) {
  const std::size_t n = line.vertices.size();
  std::vector<bool> on_chain(static_cast<std::size_t>(mesh.s.vertex_count), false);
  for (const int v : line.vertices) on_chain[v] = true;
  std::set<std::pair<int, int>> walks;
  for (std::size_t i = 0; i < mesh.s.triangles.size(); ++i) {
    const PieceId piece = mesh.p.piece_of_point[mesh.p.triangles[i].front()];
    if (!std::ranges::binary_search(line.pieces, piece)) continue;
    const auto& t = mesh.s.triangles[i];
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
  HangingChain result{chain.vertices, {}, scaled(line, needed), {}, &chain};
  const double turn = sense(mesh, chain) / (chain.closed ? chain.length : result.curve.length());
  for (std::size_t i = 0; i < n; ++i) {
    result.fractions.push_back(worn.from + turn * (chain.arc[i] - chain.centre));
    result.positions.push_back(result.curve.at(result.fractions.back()));
  }
  return result;
}

}  // namespace toile
