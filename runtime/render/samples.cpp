#include "runtime/render/samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace toile {
namespace {

/// A good 32-bit mixer (the finaliser of MurmurHash3).
std::uint32_t mixed(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x85ebca6bu;
  x ^= x >> 13;
  x *= 0xc2b2ae35u;
  x ^= x >> 16;
  return x;
}

/// The first two dimensions of Sobol's sequence: van der Corput's, and the one of the polynomial x + 1.
std::array<std::uint32_t, 2> sobol(std::uint32_t index) {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  std::uint32_t column = 1u << 31;
  for (std::uint32_t bit = 1u << 31; index != 0; index >>= 1, bit >>= 1, column ^= column >> 1) {
    if ((index & 1u) == 0) continue;
    first ^= bit;
    second ^= column;
  }
  return {first, second};
}

/// Owen's scrambling, bit for bit: every bit is flipped or not by a hash of the bits above it.
std::uint32_t owen(std::uint32_t x, std::uint32_t seed) {
  std::uint32_t result = 0;
  for (int bit = 0; bit < 32; ++bit) {
    const std::uint32_t above = bit == 0 ? 0 : x >> (32 - bit);
    const std::uint32_t flip = mixed(seed ^ mixed(above + 0x9e3779b9u * static_cast<std::uint32_t>(bit + 1))) & 1u;
    const auto shift = static_cast<std::uint32_t>(31 - bit);
    result |= (((x >> shift) & 1u) ^ flip) << shift;
  }
  return result;
}

double unit(std::uint32_t x) {
  return x * 0x1p-32;
}

}  // namespace

SampleTable::SampleTable(int count) : count_(std::clamp(count, 1, 4096)) {
  int bits = 0;
  while ((1 << bits) < count_) ++bits;
  points_.reserve(static_cast<std::size_t>(kNets) * kPurposes * static_cast<std::size_t>(count_));
  for (std::uint32_t net = 0; net < kNets; ++net) {
    for (std::uint32_t purpose = 0; purpose < kPurposes; ++purpose) {
      const std::uint32_t seed = mixed(net * kPurposes + purpose + 1);
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count_); ++i) {
        // The order is shuffled too, so that the i-th points of two purposes have nothing to do with each other.
        const std::uint32_t shuffled = bits == 0 ? 0 : owen(i << (32 - bits), seed) >> (32 - bits);
        const auto [x, y] = sobol(shuffled);
        points_.push_back({owen(x, mixed(seed ^ 0x51ed270bu)), owen(y, mixed(seed ^ 0x2545f491u))});
      }
    }
  }
}

Sample2 SampleTable::at(std::uint32_t pixel_seed, int index, Purpose purpose) const {
  const auto p = static_cast<std::uint32_t>(purpose);
  const std::size_t net = (pixel_seed % kNets) * kPurposes + p;
  const Point& point = points_[net * static_cast<std::size_t>(count_) + static_cast<std::size_t>(index)];
  // A digital shift keeps the net's strata.
  const std::uint32_t shift = mixed(pixel_seed + 0x9e3779b9u * (p + 1));
  return {unit(point[0] ^ shift), unit(point[1] ^ mixed(shift))};
}

std::uint32_t SampleTable::pixel_seed(int x, int y) {
  return mixed(static_cast<std::uint32_t>(x) + mixed(static_cast<std::uint32_t>(y) + 0x3c6ef372u));
}

// Duff et al., Building an Orthonormal Basis, Revisited (2017).
Frame::Frame(Vec3 axis) : normal(axis) {
  const double sign = std::copysign(1.0, axis.z);
  const double a = -1 / (sign + axis.z);
  const double b = axis.x * axis.y * a;
  tangent = {1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
  bitangent = {b, sign + axis.y * axis.y * a, -axis.y};
}

Vec3 cosine_direction(const Frame& frame, Sample2 sample) {
  const double radius = std::sqrt(sample.x);
  const double angle = 2 * std::numbers::pi * sample.y;
  return frame.out(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(std::max(0.0, 1 - sample.x)));
}

Vec3 cone_direction(const Frame& frame, double cos_half_angle, Sample2 sample) {
  const double height = 1 - sample.x * (1 - cos_half_angle);
  const double radius = std::sqrt(std::max(0.0, 1 - height * height));
  const double angle = 2 * std::numbers::pi * sample.y;
  return frame.out(radius * std::cos(angle), radius * std::sin(angle), height);
}

}  // namespace toile
