// The chart in which a piece is drawn that lies on a body: the preliminary map of the body's surface to the plane
// (paper, section 5). runtime/develop takes its points back to the body.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compiler/curve/curve.hpp"
#include "grammar/source.hpp"

namespace toile {

struct ChartSpec {
  enum class Map {
    Cylinder,  // (r, theta, z) about the axis to (radius * theta, z)
    Cone,      // the same onto a cone about the axis, cut open behind and unrolled: (0, 0) is the front of its line
    Dome,      // the direction from the centre: the angle off the pole times the radius, about the pole
    Conformal  // a patch of the surface itself, its angles kept as well as may be
  };
  Map map = Map::Cylinder;
  std::string line;     // its axis is the chart's; empty: upright through the middle of the body, levels from the floor
  double radius = 0.1;  // [m] of a cone at its line; 0: as the line's girth says
  double ease = 0;      // [m] from the body to the cloth
  std::optional<std::array<double, 3>> centre;  // [m] of a dome; of a conformal patch that is not a limb's
  std::optional<std::array<double, 3>> pole;    // of a dome: a direction
  double angle = 0;                             // [rad] of a cone: its side off its axis, positive: wider down the limb
  double reach = 0.15;        // [m] of a conformal patch: from its centre, or along the axis from its line
  std::optional<double> cut;  // [rad] round a limb from the front of the line: where a conformal patch is cut open
  Location written;
};

/// What a script asks of a chart while it is evaluated.
struct ChartQuestion {
  enum class Kind {
    Place,     // where a point of the body is drawn
    Line,      // how a line of the body runs
    Geodesic,  // the shortest way on the body between two places
    Drawn      // the smooth line on the body through points
  };
  Kind kind = Kind::Place;
  std::string line;
  std::vector<std::array<double, 3>> points;  // [m] near the body
  Vec2 from, to;                              // [m]
};
struct ChartAnswer {
  Vec2 place;
  Curve curve;
};

}  // namespace toile
