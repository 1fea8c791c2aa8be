// What every mesh must satisfy, told without the help of the code under test.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "compiler/smesh/cells.hpp"
#include "compiler/smesh/smesh.hpp"
#include "tests/compiler/mesh/garments.hpp"

namespace toile::test {

inline double twice_area(const PMesh& mesh, const std::array<int, 3>& t) {
  return cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
}

inline double area(const PMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += twice_area(mesh, t) / 2;
  return sum;
}

/// [deg]
inline double angle(const PMesh& mesh, const std::array<int, 3>& t, int corner) {
  const Vec2 at = mesh.points[t[corner]];
  const Vec2 a = mesh.points[t[(corner + 1) % 3]] - at, b = mesh.points[t[(corner + 2) % 3]] - at;
  return std::atan2(cross(a, b), dot(a, b)) * 180 / pi;
}

struct AngleFigures {
  double least = 180;   // [deg] of all angles away from sharp corners
  double below_25 = 0;  // share of these angles
  double below_20 = 0;
};

/// Triangles within `clearance` of a point of `sharp` are left out.
inline AngleFigures angles(const PMesh& mesh, const std::vector<Vec2>& sharp = {}, double clearance = 0) {
  AngleFigures figures;
  int count = 0, below_25 = 0, below_20 = 0;
  for (const auto& t : mesh.triangles) {
    const bool left_out = std::any_of(sharp.begin(), sharp.end(), [&](Vec2 corner) {
      return std::any_of(t.begin(), t.end(), [&](int v) { return distance(mesh.points[v], corner) <= clearance; });
    });
    if (left_out) continue;
    for (int c = 0; c < 3; ++c) {
      const double here = angle(mesh, t, c);
      figures.least = std::min(figures.least, here);
      ++count;
      below_25 += here < 25;
      below_20 += here < 20;
    }
  }
  figures.below_25 = count > 0 ? double(below_25) / count : 0;
  figures.below_20 = count > 0 ? double(below_20) / count : 0;
  return figures;
}

/// Every triangle counter-clockwise, every index in range and in use, pieces contiguous, edges' nodes on their curves.
inline void expect_sound(const PMesh& mesh, const Garment& garment) {
  std::vector<bool> used(mesh.points.size(), false);
  int flat = 0, strayed = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    for (const int v : t) {
      ASSERT_TRUE(v >= 0 && v < static_cast<int>(mesh.points.size()));
      used[v] = true;
      strayed += mesh.piece_of_point[v] != mesh.piece_of_triangle[i];
    }
    flat += !(twice_area(mesh, t) > 0);
  }
  EXPECT_EQ(flat, 0) << "triangles that are flat or turned over";
  EXPECT_EQ(strayed, 0) << "corners of another piece";
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << "vertices without a triangle";
  EXPECT_TRUE(std::is_sorted(mesh.piece_of_triangle.begin(), mesh.piece_of_triangle.end()));
  EXPECT_TRUE(std::is_sorted(mesh.piece_of_point.begin(), mesh.piece_of_point.end()));
  ASSERT_EQ(mesh.edge_nodes.size(), garment.pieces.size());
  double off = 0;
  for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
    ASSERT_EQ(mesh.edge_nodes[p].size(), static_cast<std::size_t>(garment.pieces[p].edge_count()));
    for (std::size_t e = 0; e < mesh.edge_nodes[p].size(); ++e) {
      const auto& nodes = mesh.edge_nodes[p][e];
      ASSERT_EQ(nodes.points.size(), nodes.arc.size());
      ASSERT_GE(nodes.points.size(), 2U);
      EXPECT_TRUE(std::is_sorted(nodes.arc.begin(), nodes.arc.end(), std::less_equal<>()));
      for (std::size_t i = 0; i < nodes.points.size(); ++i) {
        off = std::max(off, distance(mesh.points[nodes.points[i]],
                                     garment.pieces[p].edge(static_cast<int>(e)).curve.at(nodes.arc[i])));
      }
    }
  }
  EXPECT_LT(off, 1e-9) << "nodes off their curves [m]";
}

/// A strict complex: no repeated vertex, no two triangles alike, and no two P-edges in one S-edge but sewn ones.
inline void expect_strict(const SewnMesh& mesh) {
  using Pair = std::pair<int, int>;
  const auto pair = [](int a, int b) { return Pair(std::min(a, b), std::max(a, b)); };
  std::set<std::array<int, 3>> seen;
  std::map<Pair, std::set<Pair>> plane_edges;
  int repeated = 0, alike = 0;
  ASSERT_EQ(mesh.s.triangles.size(), mesh.p.triangles.size());
  for (std::size_t i = 0; i < mesh.s.triangles.size(); ++i) {
    auto t = mesh.s.triangles[i];
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(t[c], mesh.s.s_of_p[mesh.p.triangles[i][c]]);
      plane_edges[pair(t[c], t[(c + 1) % 3])].insert(pair(mesh.p.triangles[i][c], mesh.p.triangles[i][(c + 1) % 3]));
    }
    repeated += t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    std::sort(t.begin(), t.end());
    alike += !seen.insert(t).second;
  }
  EXPECT_EQ(repeated, 0) << "triangles with a repeated vertex";
  EXPECT_EQ(alike, 0) << "triangles with the same vertices";

  std::map<Pair, std::set<Pair>> sewn;
  for (const auto& runs : mesh.p.sewn) {
    for (const auto& run : runs) {
      for (std::size_t i = 0; i + 1 < run.first.size(); ++i) {
        const Pair a = pair(run.first[i], run.first[i + 1]), b = pair(run.second[i], run.second[i + 1]);
        sewn[a].insert(b);
        sewn[b].insert(a);
      }
    }
  }
  int unsewn = 0;
  for (const auto& [ends, edges] : plane_edges) {
    std::set<Pair> reached{*edges.begin()};
    std::vector<Pair> open{*edges.begin()};
    while (!open.empty()) {
      const Pair at = open.back();
      open.pop_back();
      for (const Pair& next : sewn[at]) {
        if (reached.insert(next).second) open.push_back(next);
      }
    }
    for (const Pair& e : edges) unsewn += !reached.contains(e);
  }
  EXPECT_EQ(unsewn, 0) << "edges with the same vertices that no seam joins";
}

/// Wings, maps and order of an S-mesh agree with its triangles.
inline void expect_consistent(const SewnMesh& mesh) {
  const SMesh& s = mesh.s;
  std::size_t wings = 0;
  for (std::size_t e = 0; e < s.edges.size(); ++e) {
    EXPECT_LT(s.edges[e].vertices[0], s.edges[e].vertices[1]);
    EXPECT_TRUE(e == 0 || s.edges[e - 1].vertices < s.edges[e].vertices);
    for (const auto wing : s.edges[e].wings) {
      ++wings;
      EXPECT_EQ(s.edge_of_corner[wing.triangle][wing.corner], static_cast<int>(e));
      std::array<int, 2> ends{s.triangles[wing.triangle][(wing.corner + 1) % 3],
                              s.triangles[wing.triangle][(wing.corner + 2) % 3]};
      std::sort(ends.begin(), ends.end());
      EXPECT_EQ(ends, s.edges[e].vertices);
    }
  }
  EXPECT_EQ(wings, 3 * s.triangles.size());
  EXPECT_EQ(s.p_of_s.size(), static_cast<std::size_t>(s.vertex_count));
  for (int v = 0; v < s.vertex_count; ++v) {
    EXPECT_TRUE(std::is_sorted(s.p_of_s[v].begin(), s.p_of_s[v].end()));
    for (const int p : s.p_of_s[v]) EXPECT_EQ(s.s_of_p[p], v);
  }
}

/// The cells of a garment tell what its meshes do.
inline void expect_cells_agree(const Garment& garment, const SewnMesh& mesh) {
  const Topology cells = sewn_topology(garment), &meshed = mesh.s.topology;
  EXPECT_EQ(cells.components, meshed.components);
  EXPECT_EQ(cells.boundary_loops, meshed.boundary_loops);
  EXPECT_EQ(cells.euler, meshed.euler);
  EXPECT_EQ(cells.orientable, meshed.orientable);
  EXPECT_EQ(cells.manifold, meshed.manifold);
}

/// Arc lengths of a chain's nodes as fractions of the whole chain, in its direction.
inline std::vector<double> fractions(const PMesh& mesh, const Chain& links) {
  std::vector<double> positions;
  double length = 0;
  for (const ChainLink& link : links) {
    const auto& nodes = mesh.edge_nodes[link.edge.piece][link.edge.edge];
    std::vector<double> here;
    for (const double s : nodes.arc) here.push_back(length + (link.forward ? s : nodes.arc.back() - s));
    if (!link.forward) std::reverse(here.begin(), here.end());
    positions.insert(positions.end(), here.begin() + (positions.empty() ? 0 : 1), here.end());
    length += nodes.arc.back();
  }
  for (double& p : positions) p /= length;
  return positions;
}

inline void expect_equal_fractions(const PMesh& mesh, const Garment& garment) {
  for (const Seam& seam : garment.seams) {
    const auto a = fractions(mesh, seam.first), b = fractions(mesh, seam.second);
    ASSERT_EQ(a.size(), b.size()) << seam.name;
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-12) << seam.name;
  }
}

}  // namespace toile::test
