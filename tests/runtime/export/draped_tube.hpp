// A hand-made drape for the tests of files and reports: a tube of two pieces, sewn at both sides, with its numbers set
// by hand so that a reader can tell where each should turn up.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "runtime/export/export.hpp"

namespace toile {

struct DrapedTube {
  Garment garment;
  SewnMesh mesh;
  Cloth cloth;
  Drape drape;

  DrapedGarment view() const { return {&garment, &mesh, &cloth, &drape}; }
};

/// Numbers sewn vertices in the order of their first P-vertex, and finds the edges and their wings.
inline SMesh sewn(const PMesh& p, const std::vector<std::pair<int, int>>& sewn_points) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> first(p.points.size());
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = static_cast<int>(i);
  for (const auto& [a, b] : sewn_points) first[at(std::max(a, b))] = std::min(a, b);

  SMesh s;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const bool is_new = first[i] == static_cast<int>(i);
    s.s_of_p.push_back(is_new ? s.vertex_count++ : s.s_of_p[at(first[i])]);
    s.p_of_s.resize(at(s.vertex_count));
    s.p_of_s[at(s.s_of_p[i])].push_back(static_cast<int>(i));
  }
  std::map<std::array<int, 2>, std::vector<SMesh::Wing>> wings;
  for (std::size_t t = 0; t < p.triangles.size(); ++t) {
    std::array<int, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) triangle[c] = s.s_of_p[at(p.triangles[t][c])];
    s.triangles.push_back(triangle);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(triangle[(c + 1) % 3], triangle[(c + 2) % 3]);
      wings[{low, high}].push_back({static_cast<int>(t), static_cast<int>(c)});
    }
  }
  s.edge_of_corner.resize(s.triangles.size());
  for (const auto& [vertices, of_edge] : wings) {
    for (const SMesh::Wing& wing : of_edge) {
      s.edge_of_corner[at(wing.triangle)][at(wing.corner)] = static_cast<int>(s.edges.size());
    }
    s.edges.push_back({vertices, of_edge, -1});
  }
  s.topology.vertices = s.vertex_count;
  s.topology.edges = static_cast<int>(s.edges.size());
  s.topology.triangles = static_cast<int>(s.triangles.size());
  s.topology.euler = s.vertex_count - s.topology.edges + s.topology.triangles;
  s.topology.components = 1;
  return s;
}

constexpr int kColumns = 12;  // of squares, each piece
constexpr int kRows = 4;
constexpr double kSquare = 0.05;  // [m]
inline const double kRadius = 2 * kColumns * kSquare / (2 * std::numbers::pi);

/// Two pieces "front" and "back", 60 cm wide and 20 cm long, warp down, as a cylinder with its upper rim at z = 0 and
/// held there; its lower rim swings out by `wave` of the radius in `folds` folds.
inline DrapedTube draped_tube(int folds = 0, double wave = 0) {
  DrapedTube tube;
  tube.garment.name = "tube";
  tube.garment.textile.name = "ticking";
  tube.garment.textile.warp = {{{240, 240, 230}, 0.03}, {{30, 40, 90}, 0.01}};
  tube.garment.textile.weft = {{{240, 240, 230}, 0.02}};

  PMesh& p = tube.mesh.p;
  constexpr int kAcross = kColumns + 1;
  const auto point = [](int piece, int column, int row) { return (piece * (kRows + 1) + row) * kAcross + column; };
  for (int piece = 0; piece < 2; ++piece) {
    tube.garment.pieces.emplace_back();
    tube.garment.pieces.back().name = piece == 0 ? "front" : "back";
    p.warp_of_piece.push_back({0, -1});
    p.edge_nodes.emplace_back();
    for (int row = 0; row <= kRows; ++row) {
      for (int column = 0; column <= kColumns; ++column) {
        p.points.push_back({column * kSquare, -row * kSquare});
        p.piece_of_point.push_back(piece);
      }
    }
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        const int a = point(piece, column, row + 1), b = point(piece, column + 1, row + 1);
        const int c = point(piece, column + 1, row), d = point(piece, column, row);
        p.triangles.push_back({a, b, c});
        p.triangles.push_back({a, c, d});
        p.piece_of_triangle.insert(p.piece_of_triangle.end(), 2, piece);
      }
    }
  }
  std::vector<std::pair<int, int>> sides;
  for (int row = 0; row <= kRows; ++row) {
    sides.emplace_back(point(0, kColumns, row), point(1, 0, row));
    sides.emplace_back(point(0, 0, row), point(1, kColumns, row));
  }
  tube.mesh.s = sewn(p, sides);
  tube.mesh.s.topology.boundary_loops = 2;
  tube.cloth = make_cloth(tube.mesh);

  SMesh::WornLine waist{.wear = 0,
                        .vertices = {},
                        .arc = {},
                        .length = 2 * kColumns * kSquare,
                        .closed = true,
                        .centre = 0,
                        .pieces = {0}};
  for (int i = 0; i < 2 * kColumns; ++i) {
    waist.vertices.push_back(tube.mesh.s.s_of_p[static_cast<std::size_t>(point(i / kColumns, i % kColumns, 0))]);
    waist.arc.push_back(i * kSquare);
  }
  tube.mesh.s.worn.push_back(waist);
  tube.garment.wears.emplace_back();
  tube.garment.wears.back().line = "waist";

  Drape& drape = tube.drape;
  drape.positions.resize(static_cast<std::size_t>(tube.mesh.s.vertex_count));
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    const double down = -p.points[i].y / (kRows * kSquare);
    const double angle = p.piece_of_point[i] * std::numbers::pi + p.points[i].x / kRadius;
    const double radius = kRadius * (1 + wave * down * std::cos(folds * angle));
    drape.positions[static_cast<std::size_t>(tube.mesh.s.s_of_p[i])] = {radius * std::cos(angle),
                                                                        radius * std::sin(angle), p.points[i].y};
  }
  for (std::size_t t = 0; t < p.triangles.size(); ++t) {
    const double piece = p.piece_of_triangle[t];
    drape.strain_warp.push_back(0.01 + 0.01 * piece);
    drape.strain_weft.push_back(-0.002);
    drape.shear_angle.push_back(0.1 * (t % 2 == 0 ? 1 : -1));
    drape.stress_warp.push_back(5 + piece);
    drape.stress_weft.push_back(-0.5);
    drape.stress_shear.push_back(2);
  }
  drape.pressure.assign(drape.positions.size(), 0.0);
  drape.pressure.front() = 30;
  drape.converged = true;
  drape.iterations = 41;
  drape.residual_N = 1e-7;
  drape.residual_relative = 2.5e-4;
  drape.residual_moment_Nm = 1e-9;
  drape.energy.stretch_warp = 0.25;
  drape.energy.gravity = -0.5;
  drape.contact.weight_N = 0.7;
  drape.contact.support_held_N = 0.5;
  drape.contact.support_body_N = 0.2;
  drape.contact.max_penetration_m = 3e-5;
  drape.contact.pressure_Pa = {1, 10, 25, 30};
  return tube;
}

}  // namespace toile
