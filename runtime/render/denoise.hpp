// Smoothing of sampled light, guided by what is free of noise.
#pragma once

#include <array>
#include <vector>

namespace toile {

/// One pixel's means over its samples.
struct Pixel {
  std::array<float, 3> colour{};    // without light
  std::array<float, 3> light{};     // on that colour
  float variance = 0;               // of the light's luminance, of the mean
  std::array<float, 3> normal{};    // zero on the backdrop
  std::array<float, 3> position{};  // in units of the stage
  float cloth = 0, form = 0;        // shares of the pixel that they cover
};

/// An edge-avoiding a-trous filter (Dammertz et al. 2010), its range in brightness scaled by the light's own standard
/// error (after Schied et al., SVGF, 2017): noise goes, shadows' edges stay. Writes `light` only. Each pixel's result
/// depends on the input alone, whoever computes it.
void smooth_light(std::vector<Pixel>& pixels, int width, int height);

}  // namespace toile
