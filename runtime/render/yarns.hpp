// Yarns are never all alike: each is a little thicker here and thinner there, which shows as faint streaks along warp
// and weft and tells the eye that a plain surface is woven.
#pragma once

#include "compiler/curve/vec2.hpp"

namespace toile {

/// A factor about 1 on the cloth's colour at (u, v) [m]; it fades where `footprint` [m] is too wide to show yarns.
double yarn_shade(Vec2 uv, Vec2 footprint);

}  // namespace toile
