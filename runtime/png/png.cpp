#include "runtime/png/png.hpp"

#include <png.h>

#include <cstddef>

namespace toile {

std::string png(const Image& image) {
  if (image.width <= 0 || image.height <= 0) return {};
  const std::size_t expected =
      std::size_t{3} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.rgb.size() != expected) return {};

  png_image control{};
  control.version = PNG_IMAGE_VERSION;
  control.width = static_cast<png_uint_32>(image.width);
  control.height = static_cast<png_uint_32>(image.height);
  control.format = PNG_FORMAT_RGB;

  // An upper bound saves the second compression that asking for the exact size would cost.
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(control), '\0');
  png_alloc_size_t size = bytes.size();
  const int ok = png_image_write_to_memory(&control, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr);
  png_image_free(&control);
  if (ok == 0) return {};
  bytes.resize(size);
  return bytes;
}

}  // namespace toile
