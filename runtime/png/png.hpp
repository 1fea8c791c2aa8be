// PNG images by libpng.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace toile {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // 3 * width * height, sRGB, top row first
};

/// Encodes as PNG, in memory; empty on failure. The bytes depend on the pixels alone.
std::string png(const Image& image);

}  // namespace toile
