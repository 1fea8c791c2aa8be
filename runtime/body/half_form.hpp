// The left half (x >= 0) of a dress form while it is built; the right half is its exact mirror image.
#pragma once

#include <array>
#include <vector>

#include "runtime/body/body.hpp"

namespace toile {

/// Loops and strips are lists of vertices. Seen from outside with the hanging direction downwards, they run to the
/// right: counter-clockwise seen from above, or from the root of a limb.
struct HalfForm {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<bool> free;  // vertices that the final fairing may move

  int add(Vec3 p, bool is_free = false);
  std::vector<int> add(const std::vector<Vec3>& ring, bool is_free = false);
  /// Two triangles between the vertices a, b of a lower line and those c, d above them, the shorter diagonal drawn.
  void quad(int a, int b, int c, int d);
  void join_strips(const std::vector<int>& lower, const std::vector<int>& upper);
  void join_loops(const std::vector<int>& lower, const std::vector<int>& upper);
};

/// A whole form: what was built, mirrored and welded along x = 0, its free vertices faired, orphans dropped.
/// `whole_of_half[i]` (and `mirror_of_half[i]` on the right) tell where a vertex of the half went, -1 for nowhere.
struct WholeForm {
  Body::Surface surface;
  std::vector<int> whole_of_half;
  std::vector<int> mirror_of_half;
};
WholeForm complete(const HalfForm& half);

}  // namespace toile
