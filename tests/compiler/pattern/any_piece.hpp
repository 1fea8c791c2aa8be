// Pieces as they come, for properties that hold of all of them.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/compiler/pattern/drafting.hpp"

namespace toile::test {

/// One of 0 … count - 1, whatever size the run has come to.
inline int pick(int count) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, count));
}

inline double anywhere(double from, double to) {
  return from + (to - from) * pick(1001) / 1000.0;
}

/// Mostly sound: corners of a polygon around a centre, edges that bulge a little, marks about where they fit.
inline DraftPiece any_piece(const std::string& name) {
  const int corners = 3 + pick(4);
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.2831853 * (i + anywhere(-0.45, 0.45)) / corners;
    points.push_back(anywhere(0.1, 0.5) * direction(angle));
  }
  DraftPiece piece;
  piece.name = name;
  for (int i = 0; i < corners; ++i) {
    const Vec2 from = points[i], to = points[(i + 1) % corners];
    const double bulge = anywhere(-1, 1);
    const Curve curve = std::abs(bulge) < 0.5 ? line(from, to) : arc_of_radius(from, to, distance(from, to) / bulge);
    piece.outline.push_back(edge("e" + std::to_string(i), curve));
  }
  if (pick(2) == 0) {
    std::reverse(piece.outline.begin(), piece.outline.end());
    for (DraftEdge& e : piece.outline) e.curve = e.curve.reversed();
  }
  const int marks = pick(4);
  for (int i = 0; i < marks; ++i) {
    const DraftEdge& host = piece.outline[pick(corners)];
    const double length = host.curve.length();
    piece.darts.push_back(dart("d" + std::to_string(i), host.name, anywhere(-0.1, 1.1) * length,
                               anywhere(0, 0.4) * length, anywhere(0, 0.4)));
    piece.notches.push_back({host.name, anywhere(-0.1, 1.1) * length, next_place()});
  }
  const int kind = pick(4);
  if (kind == 0) return paired(piece);
  if (kind == 1) return folded(piece, "e" + std::to_string(pick(corners)));
  return piece;
}

}  // namespace toile::test
