// Light as linear RGB (Rec. 709 primaries), and its way to the eight bits of a picture.
#pragma once

#include <algorithm>
#include <cstdint>

#include "compiler/pattern/textile.hpp"

namespace toile {

struct Rgb {
  double r = 0, g = 0, b = 0;

  friend constexpr bool operator==(Rgb, Rgb) = default;
};

constexpr Rgb grey(double value) {
  return {value, value, value};
}
constexpr Rgb operator+(Rgb a, Rgb b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Rgb operator-(Rgb a, Rgb b) {
  return {a.r - b.r, a.g - b.g, a.b - b.b};
}
constexpr Rgb operator*(Rgb a, Rgb b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}
constexpr Rgb operator*(double s, Rgb a) {
  return {s * a.r, s * a.g, s * a.b};
}
constexpr Rgb operator/(Rgb a, Rgb b) {
  return {a.r / b.r, a.g / b.g, a.b / b.b};
}
constexpr Rgb& operator+=(Rgb& a, Rgb b) {
  return a = a + b;
}
constexpr Rgb mix(Rgb a, Rgb b, double t) {
  return (1 - t) * a + t * b;
}
/// Relative luminance (Rec. 709).
constexpr double luminance(Rgb c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

/// The transfer function of sRGB (IEC 61966-2-1), both ways, on [0, 1].
double srgb_encode(double linear);
double srgb_decode(double encoded);

Rgb linear(Colour colour);
/// Clamped and rounded.
Colour srgb(Rgb light);

/// A photographic shoulder: the identity in shadows and middle tones, so that a cloth keeps the colour it was given,
/// then a smooth roll-off that reaches 1 only at infinity. Strictly increasing, once continuously differentiable.
double tone(double light);
inline Rgb tone(Rgb light) {
  return {tone(light.r), tone(light.g), tone(light.b)};
}

}  // namespace toile
