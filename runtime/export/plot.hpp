// Curves over axes, as SVG.
#pragma once

#include <string>
#include <vector>

#include "compiler/curve/vec2.hpp"

namespace toile {

struct PlotSeries {
  std::string name;  // in the legend; empty: none
  std::vector<Vec2> points;
  bool marks = false;  // each point by itself instead of a line through all
};

struct PlotPanel {
  std::string title;
  std::string x_axis, y_axis;
  std::vector<PlotSeries> series;
  bool same_scale = false;  // on both axes
};

/// Panels beside each other, at most three in a row.
std::string plot_svg(const std::vector<PlotPanel>& panels);

}  // namespace toile
