// From the chart in which a piece is drawn back to the body: the inverse of the preliminary map (paper, section 5).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/curve/vec2.hpp"
#include "compiler/pattern/chart_spec.hpp"
#include "runtime/body/body.hpp"

namespace toile {

class ConformalMap;

class BodyChart {
 public:
  /// A chart of that body; what is wrong with it comes back in `error`, and the chart then meets nothing.
  BodyChart(const Body& body, const ChartSpec& spec, std::string& error);

  struct Meeting {
    int times = 0;  // how often the surface is met on the way out; 1 where the chart is good
    Vec3 point;     // the first of them, moved off the body by the ease
  };
  Meeting at(Vec2 place) const;
  /// Where a point on the body is drawn; about an axis, of the turns that mean the same the one nearest to `near`.
  /// Nothing for what the chart does not show.
  std::optional<Vec2> place_of(Vec3 point, Vec2 near = {}) const;
  /// Whether places a turn apart are the same place of the body: a line round it ends where it began, a turn further.
  bool turns() const { return spec_.map == ChartSpec::Map::Cylinder || spec_.map == ChartSpec::Map::Cone; }
  double ease() const { return spec_.ease; }

 private:
  struct Ray {
    Vec3 from, along;  // along is a unit vector
  };
  Ray ray(Vec2 place) const;
  /// A place of the cylinder or the cone: the angle from the front, the height up the axis.
  struct AboutAxis {
    double angle = 0, height = 0;
  };
  AboutAxis about_axis(Vec2 place) const;
  Vec2 drawn(AboutAxis place) const;
  void lay_patch(const BodyLine* line, std::string& error);
  Meeting on_patch(Vec2 place) const;
  Vec3 eased(Vec3 point) const;
  /// What tells apart which triangles a ray may meet: its height on the axis, or its angle off the pole.
  double level(Vec2 place) const;
  void sort_triangles();

  const Body& body_;
  ChartSpec spec_;
  Vec3 origin_;             // on the axis, where the height is 0; the centre of a dome
  Vec3 up_, front_, left_;  // unit vectors; left is up x front
  std::shared_ptr<const ConformalMap> conformal_;
  double lowest_ = 0, step_ = 1;
  std::vector<std::vector<int>> shelves_;  // triangles by level
};

}  // namespace toile
