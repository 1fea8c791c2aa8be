#include "runtime/render/exposure.hpp"

#include <cmath>
#include <cstddef>

#include "runtime/render/rows.hpp"

namespace toile {
namespace {

/// The reach of the floor's shadows, in sizes of the subject; beyond it is backdrop.
constexpr double kFloorNear = 4;
constexpr double kFloorFar = 6;

/// The inverse distribution of a tent of half width 0.8 pixel: a filter by where samples fall.
double tent(double u) {
  constexpr double kReach = 0.8;
  return kReach * (u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u));
}

void add(std::array<float, 3>& sum, Vec3 v) {
  sum[0] += static_cast<float>(v.x);
  sum[1] += static_cast<float>(v.y);
  sum[2] += static_cast<float>(v.z);
}

class Exposure {
 public:
  Exposure(const Stage& stage, const Studio& studio, const Camera& camera, int width, int height, int samples)
      : stage_(stage), shading_(stage, studio), camera_(camera), width_(width), height_(height), table_(samples) {}

  Pixel at(int x, int y) const {
    const std::uint32_t seed = SampleTable::pixel_seed(x, y);
    const double share = 1.0 / table_.count();
    Pixel pixel;
    Rgb colour;
    Rgb product;
    double bright = 0;
    double bright_squared = 0;
    for (int i = 0; i < table_.count(); ++i) {
      const Shaded shaded = sample(x, y, seed, i, pixel);
      colour += share * shaded.colour;
      product += share * (shaded.colour * shaded.light);
      bright += share * luminance(shaded.light);
      bright_squared += share * luminance(shaded.light) * luminance(shaded.light);
    }
    const Rgb light = product / colour;
    pixel.colour = {static_cast<float>(colour.r), static_cast<float>(colour.g), static_cast<float>(colour.b)};
    pixel.light = {static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b)};
    pixel.variance = static_cast<float>(std::max(0.0, bright_squared - bright * bright) * share);
    const auto mean = static_cast<float>(share);
    for (float& component : pixel.normal) component *= mean;
    for (float& component : pixel.position) component *= mean;
    pixel.cloth *= mean;
    pixel.form *= mean;
    return pixel;
  }

 private:
  Shaded sample(int x, int y, std::uint32_t seed, int i, Pixel& pixel) const {
    const Sample2 lens = table_.at(seed, i, Purpose::Lens);
    const double px = x + 0.5 + tent(lens.x);
    const double py = y + 0.5 + tent(lens.y);
    const Ray ray = camera_.ray(px, py);
    const Sample2 key = table_.at(seed, i, Purpose::KeyLight);
    const Sample2 dome = table_.at(seed, i, Purpose::Dome);
    if (const auto hit = stage_.rays().nearest(ray)) {
      // Each of the pixel's samples stands for its share of the pixel.
      const double width = camera_.pixel() / std::sqrt(static_cast<double>(table_.count()));
      const Spot spot = stage_.spot(ray, *hit, width);
      add(pixel.normal, spot.normal);
      add(pixel.position, spot.position);
      (spot.actor->material == Material::Cloth ? pixel.cloth : pixel.form) += 1;
      return shading_.actor(spot, -ray.direction, key, dome);
    }
    Shaded shaded{backdrop(px / width_, py / height_), grey(1)};
    if (stage_.empty() || ray.direction.z >= 0) return shaded;
    const double distance = (stage_.floor() - ray.origin.z) / ray.direction.z;
    const Vec3 position = ray.origin + distance * ray.direction;
    const double away = norm(position);
    if (!(distance > 0) || away > kFloorFar) return shaded;
    add(pixel.normal, {0, 0, 1});
    add(pixel.position, position);
    const double fade = std::clamp((kFloorFar - away) / (kFloorFar - kFloorNear), 0.0, 1.0);
    shaded.light = mix(grey(1), shading_.floor(position, key, dome), fade);
    return shaded;
  }

  const Stage& stage_;
  Shading shading_;
  const Camera& camera_;
  int width_, height_;
  SampleTable table_;
};

}  // namespace

std::vector<Pixel> expose(const Stage& stage, const Studio& studio, const Camera& camera, int width, int height,
                          int samples) {
  std::vector<Pixel> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const Exposure exposure(stage, studio, camera, width, height, samples);
  for_each_row(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
          exposure.at(x, y);
    }
  });
  return pixels;
}

Image develop(const std::vector<Pixel>& pixels, int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(3 * pixels.size())};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Pixel& p = pixels[i];
    const Rgb light{p.colour[0] * p.light[0], p.colour[1] * p.light[1], p.colour[2] * p.light[2]};
    const Colour seen = srgb(tone(light));
    image.rgb[3 * i] = seen.r;
    image.rgb[3 * i + 1] = seen.g;
    image.rgb[3 * i + 2] = seen.b;
  }
  return image;
}

}  // namespace toile
