#include "runtime/render/colour.hpp"

#include <cmath>

namespace toile {
namespace {

std::uint8_t eight_bits(double light) {
  return static_cast<std::uint8_t>(std::lround(255 * srgb_encode(std::clamp(light, 0.0, 1.0))));
}

}  // namespace

double srgb_encode(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Rgb linear(Colour colour) {
  return {srgb_decode(colour.r / 255.0), srgb_decode(colour.g / 255.0), srgb_decode(colour.b / 255.0)};
}

Colour srgb(Rgb light) {
  return {eight_bits(light.r), eight_bits(light.g), eight_bits(light.b)};
}

double tone(double light) {
  constexpr double kShoulder = 0.72;
  if (light <= kShoulder) return std::max(light, 0.0);
  constexpr double kRoom = 1 - kShoulder;
  return kShoulder + kRoom * (1 - std::exp(-(light - kShoulder) / kRoom));
}

}  // namespace toile
