#include "runtime/export/textile_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

namespace toile {

namespace {

using Light = std::array<double, 3>;

/// IEC 61966-2-1.
double to_light(std::uint8_t code) {
  const double s = code / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

std::uint8_t to_code(double light) {
  const double s = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(s, 0.0, 1.0)));
}

/// The threads of one direction, sampled across them over one repeat.
struct Threads {
  double repeat = 0.01;  // [m]
  std::vector<Light> texels{Light{0.5, 0.5, 0.5}};
};

/// A power of two that gives the finest stripe four texels, within what viewers take with ease.
std::size_t texels_for(double repeat, double finest) {
  constexpr std::size_t kMost = 1024;
  std::size_t count = 1;
  while (count < kMost && static_cast<double>(count) * finest < 4 * repeat) count *= 2;
  return count;
}

Threads threads(const std::vector<Stripe>& all) {
  std::vector<Stripe> stripes;
  std::copy_if(all.begin(), all.end(), std::back_inserter(stripes), [](const Stripe& s) { return s.width > 0; });
  if (stripes.empty()) return {};
  double repeat = 0;
  double finest = stripes.front().width;
  for (const Stripe& stripe : stripes) {
    repeat += stripe.width;
    finest = std::min(finest, stripe.width);
  }
  const std::size_t count = stripes.size() == 1 ? 1 : texels_for(repeat, finest);
  std::vector<Light> texels(count, Light{});
  const double width = repeat / static_cast<double>(count);
  double begin = 0;
  for (const Stripe& stripe : stripes) {
    const double end = begin + stripe.width;
    const Light light{to_light(stripe.colour.r), to_light(stripe.colour.g), to_light(stripe.colour.b)};
    for (std::size_t i = 0; i < count; ++i) {
      const double left = static_cast<double>(i) * width;
      const double covered = std::max(0.0, std::min(end, left + width) - std::max(begin, left)) / width;
      for (std::size_t channel = 0; channel < 3; ++channel) texels[i][channel] += covered * light[channel];
    }
    begin = end;
  }
  return {repeat, texels};
}

}  // namespace

TextileImage textile_image(const Textile& textile) {
  const Threads along_u = threads(textile.weft);
  const Threads along_v = threads(textile.warp);
  TextileImage result;
  result.repeat_u = along_u.repeat;
  result.repeat_v = along_v.repeat;
  result.image.width = static_cast<int>(along_u.texels.size());
  result.image.height = static_cast<int>(along_v.texels.size());
  result.image.rgb.reserve(3 * along_u.texels.size() * along_v.texels.size());
  for (const Light& warp : along_v.texels) {
    for (const Light& weft : along_u.texels) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double light = 0.5 * (warp[channel] + weft[channel]);
        result.image.rgb.push_back(to_code(light));
        result.mean[channel] += light;
      }
    }
  }
  for (double& channel : result.mean) channel /= static_cast<double>(along_u.texels.size() * along_v.texels.size());
  return result;
}

}  // namespace toile
