#include "runtime/render/denoise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "runtime/render/rows.hpp"

namespace toile {
namespace {

struct Light {
  std::array<float, 3> rgb{};
  float variance = 0;
};

float brightness(const Light& light) {
  return 0.2126f * light.rgb[0] + 0.7152f * light.rgb[1] + 0.0722f * light.rgb[2];
}

float square(float x) {
  return x * x;
}

/// Pixels on an outline hold more than one light; nothing like them is near.
bool is_mixed(const Pixel& p) {
  const auto is_part = [](float share) { return share > 0.01f && share < 0.99f; };
  return is_part(p.cloth) || is_part(p.form);
}

/// How alike two pixels are in what they show, as an exponent: 0 for the same, the larger the less.
float difference(const Pixel& p, const Pixel& q) {
  constexpr float kNormal = 1 / (0.16f * 0.16f);
  constexpr float kCover = 1 / (0.1f * 0.1f);
  float turned = 0;
  float off_plane = 0;
  float apart = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    turned += square(p.normal[i] - q.normal[i]);
    off_plane += p.normal[i] * (q.position[i] - p.position[i]);
    apart += square(q.position[i] - p.position[i]);
  }
  const float slope = square(off_plane) / (0.04f * apart + 1e-6f);
  return kNormal * turned + slope + kCover * (square(p.cloth - q.cloth) + square(p.form - q.form));
}

/// A cubic B-spline at -2 … 2.
float spline(int tap) {
  return tap == 0 ? 3 / 8.f : tap == 1 || tap == -1 ? 1 / 4.f : 1 / 16.f;
}

/// One level: taps of a cubic B-spline, `step` pixels apart.
class Level {
 public:
  Level(const std::vector<Pixel>& pixels, const std::vector<Light>& from, int width, int height, int step)
      : pixels_(pixels), from_(from), width_(width), height_(height), step_(step) {}

  Light at(int x, int y) const {
    const std::size_t self = index(x, y);
    const Light& own = from_[self];
    if (is_mixed(pixels_[self])) return own;
    const float variance = near_variance(x, y);
    if (variance <= 0) return own;
    const float tolerance = 3.5f * std::sqrt(variance) + 1e-3f;
    Light sum;
    float total = 0;
    for (int j = -2; j <= 2; ++j) {
      for (int i = -2; i <= 2; ++i) {
        const int u = x + i * step_;
        const int v = y + j * step_;
        if (u < 0 || v < 0 || u >= width_ || v >= height_) continue;
        const Light& other = from_[index(u, v)];
        if (is_mixed(pixels_[index(u, v)])) continue;
        float weight = spline(i) * spline(j);
        if (i != 0 || j != 0) {
          const float exponent = difference(pixels_[self], pixels_[index(u, v)]) +
                                 std::abs(brightness(own) - brightness(other)) / tolerance;
          if (exponent > 12) continue;
          weight *= std::exp(-exponent);
        }
        total += weight;
        for (std::size_t c = 0; c < 3; ++c) sum.rgb[c] += weight * other.rgb[c];
        sum.variance += weight * weight * other.variance;
      }
    }
    for (float& channel : sum.rgb) channel /= total;
    sum.variance /= total * total;
    return sum;
  }

 private:
  /// A single pixel's variance is itself noisy, and in a thin penumbra may miss its shadow: its neighbours are asked
  /// too.
  float near_variance(int x, int y) const {
    float sum = 0;
    float total = 0;
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        const int u = x + i;
        const int v = y + j;
        if (u < 0 || v < 0 || u >= width_ || v >= height_) continue;
        const float weight = (i == 0 ? 2.f : 1.f) * (j == 0 ? 2.f : 1.f);
        sum += weight * from_[index(u, v)].variance;
        total += weight;
      }
    }
    return sum / total;
  }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  const std::vector<Pixel>& pixels_;
  const std::vector<Light>& from_;
  int width_, height_, step_;
};

}  // namespace

void smooth_light(std::vector<Pixel>& pixels, int width, int height) {
  std::vector<Light> from(pixels.size());
  std::vector<Light> to(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) from[i] = {pixels[i].light, pixels[i].variance};
  for (const int step : {1, 2, 4}) {
    const Level level(pixels, from, width, height, step);
    for_each_row(height, [&](int y) {
      for (int x = 0; x < width; ++x) {
        to[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
            level.at(x, y);
      }
    });
    from.swap(to);
  }
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i].light = from[i].rgb;
}

}  // namespace toile
