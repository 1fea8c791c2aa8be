// From the chart in which a piece is drawn back to the body: the inverse of the preliminary map (paper, section 5).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/curve/vec2.hpp"
#include "compiler/pattern/chart_spec.hpp"
#include "runtime/body/body.hpp"

namespace toile {

class BodyChart {
 public:
  /// A chart of that body; what is wrong with it comes back in `error`, and the chart then meets nothing.
  BodyChart(const Body& body, const ChartSpec& spec, std::string& error);

  struct Meeting {
    int times = 0;  // how often the surface is met on the way out; 1 where the chart is good
    Vec3 point;     // the first of them, moved off the body by the ease
  };
  Meeting at(Vec2 place) const;

 private:
  struct Ray {
    Vec3 from, along;  // along is a unit vector
  };
  Ray ray(Vec2 place) const;
  /// What tells apart which triangles a ray may meet: its height on the axis, or its angle off the pole.
  double level(Vec2 place) const;
  void sort_triangles();

  const Body& body_;
  ChartSpec spec_;
  Vec3 origin_;             // on the axis, where the height is 0; the centre of a dome
  Vec3 up_, front_, left_;  // unit vectors; left is up x front
  double lowest_ = 0, step_ = 1;
  std::vector<std::vector<int>> shelves_;  // triangles by level
};

}  // namespace toile
