#include "runtime/png/png.hpp"

#include <gtest/gtest.h>
#include <png.h>

namespace toile {
namespace {

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const int value : {7 * x + y, 3 * y, x * y}) image.rgb.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return image;
}

TEST(Png, ReadsBackPixelForPixel) {
  const Image image = gradient(37, 21);
  const std::string bytes = png(image);

  png_image control{};
  control.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&control, bytes.data(), bytes.size()), 0);
  ASSERT_EQ(control.width, 37u);
  ASSERT_EQ(control.height, 21u);
  control.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(control));
  ASSERT_NE(png_image_finish_read(&control, nullptr, read.data(), 0, nullptr), 0);
  EXPECT_EQ(read, image.rgb);
}

TEST(Png, BytesDependOnThePixelsAlone) {
  EXPECT_EQ(png(gradient(64, 64)), png(gradient(64, 64)));
  EXPECT_NE(png(gradient(64, 64)), png(gradient(64, 63)));
}

TEST(Png, RefusesWhatIsNoPicture) {
  EXPECT_EQ(png(Image{}), "");
  EXPECT_EQ(png(Image{-3, 4, {}}), "");
  EXPECT_EQ(png(Image{2, 2, std::vector<std::uint8_t>(11)}), "");
}

}  // namespace
}  // namespace toile
