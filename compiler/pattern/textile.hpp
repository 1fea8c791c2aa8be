// The colour pattern of a cloth: threads of warp and weft, repeated.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace toile {

struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;  // sRGB

  friend constexpr bool operator==(Colour, Colour) = default;
};

struct Stripe {
  Colour colour;
  double width = 0;  // [m]
};

/// A solid cloth has one stripe each way; a stripe several along one; a tartan the same list both ways. At a point (u,
/// v) the warp threads' colour depends on v (their place across the cloth) and the weft threads' on u; seen from afar
/// the two mix evenly.
struct Textile {
  std::string name;
  std::vector<Stripe> warp{{Colour{196, 178, 152}, 0.01}};
  std::vector<Stripe> weft{{Colour{196, 178, 152}, 0.01}};
};

}  // namespace toile
