// A patch of a body's surface laid in the plane by the least-squares conformal map (Levy, Petitjean, Ray and Maillot,
// 2002): of all maps the one whose angles are farthest from none and least changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/curve/vec2.hpp"
#include "runtime/body/triangle_tree.hpp"
#include "runtime/develop/patch.hpp"

namespace toile {

class ConformalMap {
 public:
  /// Where the map is to lie in the plane: this point of the patch at (0, 0), lengths about it true, and this direction
  /// there upwards.
  struct Seat {
    Vec3 origin, up;
  };
  /// Where the map folds over itself `error` says so, with the place.
  ConformalMap(Patch patch, const Seat& seat, std::string& error);

  /// Every place of the patch that is drawn here: one where the map is good.
  std::vector<Vec3> at(Vec2 place) const;
  /// Where the point of the patch nearest to `p` is drawn, none where that is farther than `reach` [m].
  std::optional<Vec2> place_of(Vec3 p, double reach) const;

 private:
  bool lay_out();
  void seat(const Seat& seat);
  void sort_triangles();
  std::array<Vec2, 3> corners(std::size_t triangle) const;

  Patch patch_;
  TriangleTree tree_;
  std::vector<Vec2> places_;  // of its points
  Vec2 low_;
  double cell_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<int>> cells_;  // triangles
};

}  // namespace toile
