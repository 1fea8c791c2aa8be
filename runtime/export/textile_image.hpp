// One repeat of a textile as a picture, for formats that carry the cloth's pattern as a texture.
#pragma once

#include <array>

#include "compiler/pattern/textile.hpp"
#include "runtime/png/png.hpp"

namespace toile {

struct TextileImage {
  /// Columns run along u (the warp's direction), rows along v; sides are powers of two. A texel holds the mean of warp
  /// and weft over its area, mixed as light is.
  Image image;
  double repeat_u = 0;              // [m] one repeat of the weft threads' colours
  double repeat_v = 0;              // [m] one repeat of the warp threads' colours
  std::array<double, 3> mean = {};  // of all texels, linear light in 0 … 1
};

TextileImage textile_image(const Textile& textile);

}  // namespace toile
