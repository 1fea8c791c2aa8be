// The little of SVG that drawings of patterns need. Coordinates come in metres with y up and go out in millimetres with
// y down.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/curve/curve.hpp"

namespace toile::svg {

/// Text as XML allows it: markup escaped, control characters dropped.
std::string escaped(std::string_view text);
/// Millimetres of a length in metres, to a hundredth, without trailing zeros.
std::string mm(double metres);
/// "x,y" in millimetres.
std::string place(Vec2 point);

/// Path data that follow the curves exactly, by L, A and C, as one subpath.
std::string path_data(const std::vector<const Curve*>& curves, bool closed);
std::string polygon_data(const std::vector<Vec2>& points);

std::string path(std::string_view css_class, std::string_view data);
std::string line(std::string_view css_class, Vec2 from, Vec2 to);
/// Centred on its place in both directions; `angle` [rad] of the writing direction, y up; `size` [m] of the letters.
std::string text(std::string_view css_class, Vec2 at, double size, std::string_view content, double angle = 0);
/// About how wide a text comes out [m].
double text_width(std::string_view content, double size);

}  // namespace toile::svg
