// The scale beside a picture in false colours.
#pragma once

#include "runtime/png/png.hpp"
#include "runtime/render/field_scale.hpp"

namespace toile {

/// The strip at the right that the bar and its labels take, in pixels.
double scale_bar_width(int width, int height);

/// The colour bar with ticks in the field's unit, its name above, and the field's own least and greatest value at the
/// ends; an end is pointed where values lie beyond it.
void draw_scale_bar(Image& image, const FieldScale& scale);

/// Where the bar's colours are, in pixels; from `bottom` (low) up to `top` (high).
struct BarPlace {
  int left = 0, right = 0, top = 0, bottom = 0;
};
BarPlace scale_bar_place(int width, int height);

}  // namespace toile
