// The chart in which a piece is drawn that lies on a body: the preliminary map of the body's surface to the plane
// (paper, section 5). runtime/develop takes its points back to the body.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "grammar/source.hpp"

namespace toile {

struct ChartSpec {
  enum class Map {
    Cylinder,  // (r, theta, z) about the axis to (radius * theta, z)
    Dome       // the direction from the centre: the angle off the pole times the radius, about the pole
  };
  Map map = Map::Cylinder;
  std::string line;     // its axis is the chart's; empty: upright through the middle of the body, levels from the floor
  double radius = 0.1;  // [m]
  double ease = 0;      // [m] from the body to the cloth
  std::optional<std::array<double, 3>> centre;  // of a dome [m]
  std::optional<std::array<double, 3>> pole;    // of a dome: a direction
  Location written;
};

}  // namespace toile
