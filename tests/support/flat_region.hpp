// Plane regions meshed and laid on surfaces by maps given in closed form: the stuff of flattening tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "compiler/pattern/draft.hpp"
#include "compiler/pmesh/pmesh.hpp"
#include "runtime/develop/flatten.hpp"
#include "runtime/fabric/law.hpp"

namespace toile::test {

using Surface = std::function<Vec3(Vec2)>;

/// Acts alike in all directions and in tension and compression: modulus Y [N/m], no Poisson effect.
inline FabricLaw isotropic(double modulus) {
  FabricSheet sheet;
  sheet.stretch = WarpWeft{modulus, modulus};
  sheet.shear = modulus / 2;
  return make_law(sheet);
}

inline FabricLaw orthotropic(double warp, double weft, double shear) {
  FabricSheet sheet;
  sheet.stretch = WarpWeft{warp, weft};
  sheet.shear = shear;
  return make_law(sheet);
}

inline FlatteningInput laid(const std::vector<Vec2>& points, const std::vector<std::array<int, 3>>& triangles,
                            const Surface& surface) {
  FlatteningInput input;
  input.triangles = triangles;
  input.start = points;
  for (const Vec2 point : points) input.target.push_back(surface(point));
  return input;
}

/// A rectangle [0, width] x [0, height] in squares halved along alternating diagonals; its grain line is its first
/// column, or where `along_warp` its first row.
inline FlatteningInput grid(double width, double height, int columns, int rows, const Surface& surface) {
  std::vector<Vec2> points;
  std::vector<std::array<int, 3>> triangles;
  const auto at = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) points.push_back({width * i / columns, height * j / rows});
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if ((i + j) % 2 == 0) {
        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      } else {
        triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
      }
    }
  }
  FlatteningInput input = laid(points, triangles, surface);
  input.grain = {{at(0, rows / 2), at(columns, rows / 2)}};
  return input;
}

/// What a closed outline encloses, meshed as pieces are.
inline PMesh meshed(const Curve& outline, double edge) {
  const double half = outline.length() / 2;
  DraftGarment draft;
  DraftPiece piece;
  piece.name = "region";
  piece.outline = {{"first", outline.part(0, half), {}}, {"second", outline.part(half, outline.length()), {}}};
  draft.name = "g";
  draft.pieces = {piece};
  std::vector<Diagnostic> found;
  const Garment garment = make_garment(draft, found);
  PMeshOptions options;
  options.target_edge = edge;
  options.chord_error = 1e-3 * edge;
  return make_pmesh(garment, options);
}

inline Vec2 turned(Vec2 p, double angle) {
  return p.x * direction(angle) + p.y * perpendicular(direction(angle));
}

/// The warp lies at that angle [rad].
inline FlatteningInput region(const Curve& curve, double edge, const Surface& surface, double warp = 0) {
  std::vector<int> outline;
  const PMesh mesh = meshed(curve, edge);
  FlatteningInput input = laid(mesh.points, mesh.triangles, surface);
  for (const PMesh::EdgeNodes& nodes : mesh.edge_nodes[0]) {
    outline.insert(outline.end(), nodes.points.begin(), nodes.points.end() - 1);
  }
  for (Vec2& p : input.start) p = turned(p, -warp);
  input.grain = {grain_line(input.start, outline)};
  return input;
}

inline double total(const Flattened& flat) {
  return flat.energy.warp + flat.energy.weft + flat.energy.shear;
}

inline double largest_strain(const Flattened& flat) {
  double largest = 0;
  for (const MembraneStrain& strain : flat.strains) {
    largest = std::max({largest, std::abs(strain.warp), std::abs(strain.weft), std::abs(strain.shear)});
  }
  return largest;
}

}  // namespace toile::test
