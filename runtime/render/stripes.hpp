// The textile's colour at a place of the cloth, averaged over a width so that fine stripes do not flicker.
#pragma once

#include <vector>

#include "compiler/curve/vec2.hpp"
#include "compiler/pattern/textile.hpp"
#include "runtime/render/colour.hpp"

namespace toile {

/// Threads of one system, repeated without end; the first stripe begins at 0.
class Stripes {
 public:
  /// Stripes without width are left out; with none left the colour is that of the first, or a grey.
  explicit Stripes(const std::vector<Stripe>& stripes);

  /// The mean colour over [place - width/2, place + width/2], in linear light.
  Rgb mean(double place, double width) const;
  Rgb mean() const { return whole_; }

 private:
  Rgb integral(double place) const;  // from 0, over any number of repeats

  std::vector<double> ends_;  // where each stripe ends, ascending
  std::vector<Rgb> colours_;
  std::vector<Rgb> integrals_;  // up to where each stripe begins
  double repeat_ = 0;           // 0: solid
  Rgb whole_;
};

/// Warp and weft seen together: half of each.
class TextileColour {
 public:
  explicit TextileColour(const Textile& textile) : warp_(textile.warp), weft_(textile.weft) {}

  /// `footprint`: the width of what one sample stands for, along u and v [m].
  Rgb at(Vec2 uv, Vec2 footprint) const {
    return mix(warp_.mean(uv.y, footprint.y), weft_.mean(uv.x, footprint.x), 0.5);
  }
  Rgb mean() const { return mix(warp_.mean(), weft_.mean(), 0.5); }

 private:
  Stripes warp_, weft_;
};

}  // namespace toile
