// Colours for numbers. Both maps run through control points in Oklab (Ottosson 2020) and are re-parametrised by
// arc length there, so that equal steps of the value look like equal steps of colour.
#pragma once

#include "runtime/render/colour.hpp"

namespace toile {

/// t in [0, 1], clamped: dark violet over blue-green to yellow, lightness always rising.
Rgb sequential_colour(double t);

/// t in [-1, 1], clamped: blue over near white at 0 to red, both arms of equal length in Oklab.
Rgb diverging_colour(double t);

/// Oklab lightness, 0 … 1.
double lightness(Rgb light);
/// Distance in Oklab.
double colour_difference(Rgb a, Rgb b);

}  // namespace toile
