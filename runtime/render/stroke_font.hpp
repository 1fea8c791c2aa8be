// A small alphabet of strokes for the labels of a picture.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/curve/vec2.hpp"

namespace toile {

using Stroke = std::vector<Vec2>;  // a polyline; a single point is a dot

/// A line of text as strokes in units of the height of capitals: the baseline is y = 0, y points up. ASCII and "°";
/// what the alphabet lacks is a box.
std::vector<Stroke> text_strokes(std::string_view text);
double text_width(std::string_view text);

}  // namespace toile
