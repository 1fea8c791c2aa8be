#include "runtime/place/chain_parts.hpp"

#include <algorithm>

namespace toile {
namespace {

// All that is reached from `seed` without crossing what is `seen`.
std::vector<int> reached(const RestMesh& rest, int seed, std::vector<bool>& seen) {
  seen[seed] = true;
  std::vector<int> part{seed};
  for (std::size_t i = 0; i < part.size(); ++i) {
    for (const int t : rest.triangles_at(part[i])) {
      for (const int v : rest.cloth().triangles[t].vertices) {
        if (seen[v]) continue;
        seen[v] = true;
        part.push_back(v);
      }
    }
  }
  return part;
}

}  // namespace

std::vector<bool> on_any_chain(const std::vector<HungLine>& hung, std::size_t vertex_count) {
  std::vector<bool> on_chain(vertex_count, false);
  for (const HungLine& h : hung) {
    for (const int v : h.chain.vertices) on_chain[v] = true;
  }
  return on_chain;
}

bool touches(const RestMesh& rest, int vertex, const std::vector<bool>& marked) {
  const auto& triangles = rest.triangles_at(vertex);
  return std::any_of(triangles.begin(), triangles.end(), [&](int t) {
    const auto& corners = rest.cloth().triangles[t].vertices;
    return std::any_of(corners.begin(), corners.end(), [&](int v) { return marked[v]; });
  });
}

std::vector<ChainPart> parts_between_chains(const RestMesh& rest, const std::vector<int>& members,
                                            const std::vector<HungLine>& hung) {
  const auto n = static_cast<std::size_t>(rest.vertex_count());
  std::vector<ChainPart> parts;
  std::vector<bool> seen = on_any_chain(hung, n);
  for (const int seed : members) {
    if (seen[seed]) continue;
    ChainPart part{reached(rest, seed, seen), {}};
    std::vector<bool> inside(n, false);
    for (const int v : part.vertices) inside[v] = true;
    for (std::size_t l = 0; l < hung.size(); ++l) {
      const std::vector<int>& chain = hung[l].chain.vertices;
      if (std::any_of(chain.begin(), chain.end(), [&](int v) { return touches(rest, v, inside); })) {
        part.bounds.push_back(static_cast<int>(l));
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace toile
