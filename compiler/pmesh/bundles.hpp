// Which parts of the outlines are divided alike because they are sewn together.
#pragma once

#include <vector>

#include "compiler/pattern/pattern.hpp"

namespace toile {

/// One edge of a piece's outline or hole, in the flat numbering used while meshing.
struct OutlineEdge {
  PieceId piece = 0;
  int loop = 0;  // 0 the outline, then the holes, then the lines inside, which need not close
  const Curve* curve = nullptr;
  double length = 0;           // [m]
  std::vector<double> breaks;  // [m] arc lengths where a node must be: both ends, kinks, ends of edges sewn across
  int first_stretch = 0;       // its stretches are numbered on from here, one between two breaks
};

/// The part of an edge between two breaks. Stretches that are sewn together belong to one bundle: a node at the
/// fraction t of one means nodes at the fraction t of all, or at 1 - t where `forward` differs.
struct Stretch {
  int edge = 0;
  double from = 0, to = 0;  // [m] arc lengths along the edge
  int bundle = 0;
  bool forward = true;

  double length() const { return to - from; }
};

/// Two stretches that a seam joins; the flags tell whether the seam walks them as their outlines do.
struct SewnStretches {
  int first = 0, second = 0;
  bool first_forward = true, second_forward = true;
};

struct Bundles {
  std::vector<OutlineEdge> edges;
  std::vector<std::vector<std::vector<int>>> loops;  // [piece][loop]: edges
  std::vector<int> closed;                           // [piece]: so many of its loops close; the rest are lines
  std::vector<Stretch> stretches;
  std::vector<std::vector<int>> members;          // [bundle]: stretches, ascending
  std::vector<std::vector<SewnStretches>> seams;  // [seam], in the order of its chains

  /// A piece's edges are numbered one after another, loop by loop.
  int edge(EdgeRef ref) const { return loops[ref.piece][0][0] + ref.edge; }
};

/// Breaks are carried across the seams until every corner on one side of a seam has its node on the other. Corners of
/// two chains that face each other within `tolerance` [m] are meant to meet and share a node; between such pairs nodes
/// lie at equal fractions. A stretch that would be sewn to itself turned round gets a break in its middle.
Bundles make_bundles(const Garment& garment, double tolerance);

}  // namespace toile
