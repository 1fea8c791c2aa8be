// From a stage in a studio to a picture's pixels.
#pragma once

#include <vector>

#include "runtime/render/camera.hpp"
#include "runtime/render/denoise.hpp"
#include "runtime/render/shading.hpp"

namespace toile {

/// Shoots `samples` rays through every pixel, in parallel; each pixel by itself, so that the number of threads does not
/// show.
std::vector<Pixel> expose(const Stage& stage, const Studio& studio, const Camera& camera, int width, int height,
                          int samples);

/// Colour times light, through the tone curve, to eight bits.
Image develop(const std::vector<Pixel>& pixels, int width, int height);

}  // namespace toile
