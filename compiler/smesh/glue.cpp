#include "compiler/smesh/glue.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "compiler/smesh/disjoint_sets.hpp"

namespace toile {
namespace {

void unify_vertices(const PMesh& mesh, SMesh& s) {
  DisjointSets sets(mesh.points.size());
  for (const auto& runs : mesh.sewn) {
    for (const PMesh::SewnRun& run : runs) {
      for (std::size_t i = 0; i < run.first.size(); ++i) sets.unite(run.first[i], run.second[i]);
    }
  }
  s.s_of_p.assign(mesh.points.size(), -1);
  for (int p = 0; p < static_cast<int>(mesh.points.size()); ++p) {
    const int root = sets.find(p);  // the smallest of its set, so numbered already or p itself
    if (root == p) {
      s.s_of_p[p] = s.vertex_count++;
      s.p_of_s.emplace_back();
    }
    s.s_of_p[p] = s.s_of_p[root];
    s.p_of_s[s.s_of_p[p]].push_back(p);
  }
}

void list_edges(SMesh& s) {
  struct Half {
    int low, high, triangle, corner;
    auto operator<=>(const Half&) const = default;  // NOLINT(modernize-use-nullptr): taken for one by clang-tidy 14
  };
  std::vector<Half> halves;
  halves.reserve(3 * s.triangles.size());
  for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(s.triangles[t][(c + 1) % 3], s.triangles[t][(c + 2) % 3]);
      halves.push_back({low, high, t, c});
    }
  }
  std::sort(halves.begin(), halves.end());
  s.edge_of_corner.assign(s.triangles.size(), {-1, -1, -1});
  for (const Half& h : halves) {
    if (s.edges.empty() || s.edges.back().vertices != std::array{h.low, h.high}) {
      s.edges.push_back({{h.low, h.high}, {}, -1});
    }
    s.edges.back().wings.push_back({h.triangle, h.corner});
    s.edge_of_corner[h.triangle][h.corner] = static_cast<int>(s.edges.size()) - 1;
  }
}

SMesh::Edge* edge_between(SMesh& s, int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  const std::array<int, 2> ends{low, high};
  const auto edge = std::lower_bound(s.edges.begin(), s.edges.end(), ends,
                                     [](const SMesh::Edge& e, const auto& v) { return e.vertices < v; });
  return edge != s.edges.end() && edge->vertices == ends ? &*edge : nullptr;
}

/// Puts the wings of those two sides first.
void pair_wings(const PMesh& mesh, const std::array<int, 2>& first, const std::array<int, 2>& second,
                SMesh::Edge& edge) {
  const auto rank = [&](const SMesh::Wing& wing) {
    const auto& t = mesh.triangles[wing.triangle];
    const auto [low, high] = std::minmax(t[(wing.corner + 1) % 3], t[(wing.corner + 2) % 3]);
    const std::array<int, 2> side{low, high};
    return side == first ? 0 : side == second ? 1 : 2;
  };
  std::stable_sort(edge.wings.begin(), edge.wings.end(),
                   [&](const SMesh::Wing& a, const SMesh::Wing& b) { return rank(a) < rank(b); });
}

/// Where a line inside a piece is sewn: the wings of its own cloth first. Of two lines of one piece those first that
/// lie outside of the strip between them.
void pair_wings_at_line(const PMesh& mesh, const std::array<int, 2>& line, const std::array<int, 2>& other, Vec2 beyond,
                        SMesh::Edge& edge) {
  pair_wings(mesh, line, other, edge);
  const auto of_line = [&](const SMesh::Wing& wing, const std::array<int, 2>& side) {
    const auto& t = mesh.triangles[wing.triangle];
    const auto [low, high] = std::minmax(t[(wing.corner + 1) % 3], t[(wing.corner + 2) % 3]);
    return std::array<int, 2>{low, high} == side;
  };
  const auto count = [&](const std::array<int, 2>& side) {
    return std::count_if(edge.wings.begin(), edge.wings.end(), [&](const auto& wing) { return of_line(wing, side); });
  };
  if (count(line) != 2 || count(other) != 2) return;
  edge.pairs = 2;
  if (mesh.piece_of_point[line[0]] != mesh.piece_of_point[other[0]]) return;
  const auto between = [&](const SMesh::Wing& wing) {
    const bool first = of_line(wing, line);
    const Vec2 on = mesh.points[first ? line[0] : other[0]];
    const Vec2 along = mesh.points[first ? line[1] : other[1]] - on;
    const Vec2 across = mesh.points[mesh.triangles[wing.triangle][wing.corner]] - on;
    const Vec2 towards = first ? beyond : -beyond;
    return cross(along, across) * cross(along, towards) > 0;
  };
  std::stable_sort(edge.wings.begin(), edge.wings.end(),
                   [&](const SMesh::Wing& a, const SMesh::Wing& b) { return between(a) < between(b); });
}

std::array<int, 2> side_of(const std::vector<int>& run, std::size_t i) {
  const auto [low, high] = std::minmax(run[i], run[i + 1]);
  return {low, high};
}

/// Which of a seam's chains runs over a line inside a piece; the first one, where both do.
enum class Lines { None, First, Second };

Lines lines_of(const Garment& garment, const Seam& seam) {
  const auto inside = [&](const Chain& chain) {
    const EdgeRef& edge = chain.front().edge;
    return garment.pieces[edge.piece].is_inside(edge.edge);
  };
  return inside(seam.first) ? Lines::First : inside(seam.second) ? Lines::Second : Lines::None;
}

/// An edge lies on the seam that joins it, before it lies on one of its further layers or of a pleat.
void mark_seams(const Garment& garment, const PMesh& mesh, SMesh& s) {
  for (const bool further : {false, true}) {
    for (int seam = 0; seam < static_cast<int>(mesh.sewn.size()); ++seam) {
      if ((garment.seams[seam].is_layer || garment.seams[seam].is_pleat) != further) continue;
      for (const PMesh::SewnRun& run : mesh.sewn[seam]) {
        for (std::size_t i = 0; i + 1 < run.first.size(); ++i) {
          SMesh::Edge* edge = edge_between(s, s.s_of_p[run.first[i]], s.s_of_p[run.first[i + 1]]);
          if (edge == nullptr || edge->seam >= 0) continue;
          edge->seam = seam;
          if (edge->wings.size() == 2) edge->crease = garment.seams[seam].angle;
          if (edge->wings.size() <= 2) continue;
          const Vec2 beyond = mesh.points[run.second[i]] - mesh.points[run.first[i]];
          switch (lines_of(garment, garment.seams[seam])) {
            case Lines::None:
              pair_wings(mesh, side_of(run.first, i), side_of(run.second, i), *edge);
              break;
            case Lines::First:
              pair_wings_at_line(mesh, side_of(run.first, i), side_of(run.second, i), beyond, *edge);
              break;
            case Lines::Second:
              pair_wings_at_line(mesh, side_of(run.second, i), side_of(run.first, i), -beyond, *edge);
              break;
          }
        }
      }
    }
  }
}

/// The crease lines of a piece: straight, with the angle that they are pressed to.
struct Crease {
  Vec2 from, along;
  double length = 0;
  double angle = 0;

  bool holds(Vec2 p) const {
    constexpr double kOn = 1e-7;  // [m]
    const double s = dot(p - from, along);
    return std::abs(cross(along, p - from)) < kOn && s > -kOn && s < length + kOn;
  }
};

std::vector<Crease> creases_of(const Piece& piece) {
  // Pressed folds spring open a little.
  constexpr double kPressed = 170 * std::numbers::pi / 180;
  std::vector<Crease> creases;
  for (const LineMark& mark : piece.marks) {
    if (!mark.folded()) continue;
    const double angle = mark.kind == LineMark::Kind::Crease ? mark.angle
                         : mark.kind == LineMark::Kind::Fold ? kPressed
                                                             : -kPressed;
    const Vec2 from = mark.curve.start(), to = mark.curve.end();
    const double length = distance(from, to);
    if (length > 0) creases.push_back({from, (to - from) / length, length, angle});
  }
  return creases;
}

void mark_creases(const Garment& garment, const PMesh& mesh, SMesh& s) {
  std::vector<std::vector<Crease>> creases;
  for (const Piece& piece : garment.pieces) creases.push_back(creases_of(piece));
  for (SMesh::Edge& edge : s.edges) {
    if (edge.wings.size() != 2 || edge.seam >= 0) continue;
    const SMesh::Wing& wing = edge.wings.front();
    const auto& t = mesh.triangles[wing.triangle];
    const Vec2 a = mesh.points[t[(wing.corner + 1) % 3]], b = mesh.points[t[(wing.corner + 2) % 3]];
    for (const Crease& crease : creases[mesh.piece_of_triangle[wing.triangle]]) {
      if (crease.holds(a) && crease.holds(b)) edge.crease = crease.angle;
    }
  }
}

}  // namespace

SMesh glue(const Garment& garment, const PMesh& mesh) {
  SMesh s;
  unify_vertices(mesh, s);
  s.triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) s.triangles.push_back({s.s_of_p[a], s.s_of_p[b], s.s_of_p[c]});
  list_edges(s);
  mark_seams(garment, mesh, s);
  mark_creases(garment, mesh, s);
  return s;
}

}  // namespace toile
