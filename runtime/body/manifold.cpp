#include "runtime/body/manifold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace toile {
namespace {

struct HalfEdge {
  int from, to, triangle;
  friend bool operator<(const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.from, a.to, a.triangle) < std::tie(b.from, b.to, b.triangle);
  }
};

std::vector<HalfEdge> sorted_half_edges(const Body::Surface& surface) {
  std::vector<HalfEdge> edges;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& v = surface.triangles[t];
    for (int c = 0; c < 3; ++c) edges.push_back({v[c], v[(c + 1) % 3], static_cast<int>(t)});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::string place(const Body::Surface& surface, int vertex) {
  const Vec3 p = surface.points[vertex];
  return fmt::format("near ({:.3f}, {:.3f}, {:.3f}) m", p.x, p.y, p.z);
}

std::string edge_fault(const Body::Surface& surface, const std::vector<HalfEdge>& edges) {
  const auto same_way = [](const HalfEdge& a, const HalfEdge& b) { return a.from == b.from && a.to == b.to; };
  const auto doubled = std::adjacent_find(edges.begin(), edges.end(), same_way);
  if (doubled != edges.end()) {
    return fmt::format("{} an edge has more than two faces, or faces that turn opposite ways",
                       place(surface, doubled->from));
  }
  for (const HalfEdge& edge : edges) {
    const auto twin = std::lower_bound(edges.begin(), edges.end(), HalfEdge{edge.to, edge.from, -1});
    if (twin == edges.end() || twin->from != edge.to || twin->to != edge.from) {
      return fmt::format("the surface is not closed: {} an edge has one face only", place(surface, edge.from));
    }
  }
  return {};
}

// Around each vertex the triangles must form a single fan: following the half edges that leave it, every one is met.
std::string fan_fault(const Body::Surface& surface, const std::vector<HalfEdge>& edges) {
  std::size_t begin = 0;
  while (begin < edges.size()) {
    std::size_t end = begin;
    while (end < edges.size() && edges[end].from == edges[begin].from) ++end;
    std::size_t met = 0;
    int to = edges[begin].to;
    do {
      const auto edge =
          std::lower_bound(edges.begin() + begin, edges.begin() + end, HalfEdge{edges[begin].from, to, -1});
      const auto& v = surface.triangles[edge->triangle];
      const auto apex = std::find_if(v.begin(), v.end(), [&](int w) { return w != edge->from && w != edge->to; });
      to = *apex;
      ++met;
    } while (to != edges[begin].to && met < end - begin);
    if (met != end - begin) return fmt::format("{} two parts touch in a point", place(surface, edges[begin].from));
    begin = end;
  }
  return {};
}

}  // namespace

std::string manifold_fault(const Body::Surface& surface) {
  if (surface.triangles.empty()) return "there are no faces";
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3 p = surface.points[a], q = surface.points[b], r = surface.points[c];
    const Vec3 normal = cross(q - p, r - p);
    const double longest = std::max({norm(q - p), norm(r - q), norm(p - r)});
    if (!(norm(normal) > 1e-9 * longest * longest)) {
      return fmt::format("{} a face has no area", place(surface, a));
    }
  }
  const std::vector<HalfEdge> edges = sorted_half_edges(surface);
  if (std::string fault = edge_fault(surface, edges); !fault.empty()) return fault;
  return fan_fault(surface, edges);
}

double signed_volume(const Body::Surface& surface) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    six_volumes += dot(surface.points[a], cross(surface.points[b], surface.points[c]));
  }
  return six_volumes / 6;
}

void face_outwards(Body::Surface& surface) {
  if (signed_volume(surface) >= 0) return;
  for (auto& t : surface.triangles) std::swap(t[1], t[2]);
}

}  // namespace toile
