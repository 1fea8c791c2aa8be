#include "runtime/render/render.hpp"

#include <algorithm>

#include "runtime/render/exposure.hpp"
#include "runtime/render/scale_bar.hpp"

namespace toile {

Image render(const std::vector<DressedCloth>& cloths, const Body* body, const RenderOptions& options) {
  constexpr int kLargest = 16384;
  const int width = std::clamp(options.width, 1, kLargest);
  const int height = std::clamp(options.height, 1, kLargest);
  const Stage stage(cloths, body);
  const FieldScale* scale = stage.scale();

  constexpr double kMargin = 0.07;
  const double subject_width = scale ? width - scale_bar_width(width, height) : width;
  const Aim towards = aim(options.view);
  const Camera camera(towards, {0, 0, subject_width, static_cast<double>(height)}, stage.framed(), kMargin);

  std::vector<Pixel> pixels = expose(stage, Studio(towards), camera, width, height, options.samples);
  smooth_light(pixels, width, height);
  Image image = develop(pixels, width, height);
  if (scale) draw_scale_bar(image, *scale);
  return image;
}

}  // namespace toile
