// Delaunay refinement of a plane domain whose outline is already divided. The one place that knows CGAL.
#pragma once

#include <array>
#include <vector>

#include "compiler/curve/vec2.hpp"

namespace toile {

/// A closed polygon for every loop: the outer one first, counter-clockwise; holes clockwise.
using Loops = std::vector<std::vector<Vec2>>;

/// A disc in which triangles must be smaller than elsewhere.
struct SizeSpot {
  Vec2 centre;
  double radius = 0;  // [m]
  double edge = 0;    // [m]
};

/// What to triangulate: polygons, lines inside that edges must follow, and nodes that must be there.
struct PlaneDomain {
  Loops loops;
  std::vector<Vec2> pins;
  std::vector<Vec2> line_nodes;         // of the lines, but those that they share with the loops
  std::vector<std::vector<int>> lines;  // into the loops' nodes, one loop after another, and then the lines' own
};

struct TriangulationSize {
  double edge = 0;      // [m] the usual length of an edge inside
  double shortest = 0;  // [m] a side or triangle this small is not refined for its angles' sake
  std::vector<SizeSpot> spots;
};

/// A place where refinement wants the side from node `from` of a loop to the next node divided.
struct OutlineSplit {
  int loop = 0;  // the lines come after the loops
  int from = 0;
  double fraction = 0;  // of the side, 0 < fraction < 1

  friend constexpr bool operator==(const OutlineSplit&, const OutlineSplit&) = default;
};

/// Plain triangles: the loops' nodes come first, in order, then the lines' own, the pins, and the nodes inside, sorted
/// by place. Triangles are counter-clockwise, each starts with its smallest node, sorted.
struct Triangulation {
  std::vector<Vec2> points;
  std::vector<std::array<int, 3>> triangles;
  int fixed = 0;  // nodes of the loops, lines and pins, which come first
  /// Not empty when good angles need more nodes on the outline, or when sides of it cross; then there are no triangles.
  std::vector<OutlineSplit> wanted;
};

enum class Outline {
  MayAsk,  // tell which sides should be split
  Frozen,  // make the best of the outline as it is
};

/// Delaunay refinement by circumcentres. A side of the outline is split when a circumcentre falls behind it or into its
/// diametral lens (Shewchuk, Delaunay refinement algorithms for triangular mesh generation, 2002, section 4.2); sides
/// at corners below 60 degrees are split on shells of radius 2^k m about the corner, and the triangles between two
/// shells are left alone. The number of nodes is bounded by the domain's area over the square of the edge length and by
/// the number of the outline's nodes, whatever the shape.
Triangulation triangulate(const PlaneDomain& domain, const TriangulationSize& size, Outline outline);

}  // namespace toile
