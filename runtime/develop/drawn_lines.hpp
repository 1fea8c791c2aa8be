// Lines on a body as a chart shows them: its own lines, shortest ways, lines through points. Pieces are bounded by
// them.
#pragma once

#include <string>

#include "compiler/pattern/chart_spec.hpp"
#include "runtime/body/body.hpp"
#include "runtime/develop/chart.hpp"

namespace toile {

/// Curves are within 0.1 mm of the line in the chart. What cannot be answered comes back in words in `error`.
ChartAnswer answer(const ChartQuestion& question, const Body& body, const BodyChart& chart, std::string& error);

/// The shortest way on the body's surface near that between two places that the chart shows as straight: points with
/// both ends. Nothing where the chart does not show the ends or what lies between them.
std::vector<Vec3> shortest_way(const Body& body, const BodyChart& chart, Vec2 from, Vec2 to);

}  // namespace toile
