// Where a pixel puts its samples: Owen-scrambled (0, 2)-nets (Owen 1995, Kollig & Keller 2002), the same for the same
// pixel whoever computes it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runtime/mesh/vec3.hpp"

namespace toile {

struct Sample2 {
  double x = 0, y = 0;  // in [0, 1)
};

/// What a sample is drawn for; points for different purposes are decorrelated.
enum class Purpose { Lens, KeyLight, Dome };

class SampleTable {
 public:
  /// `count` samples a pixel, at least 1.
  explicit SampleTable(int count);

  int count() const { return count_; }
  Sample2 at(std::uint32_t pixel_seed, int index, Purpose purpose) const;

  static std::uint32_t pixel_seed(int x, int y);

 private:
  static constexpr int kNets = 64;  // different scramblings shared by all pixels, each shifted anew by the pixel
  static constexpr int kPurposes = 3;
  using Point = std::array<std::uint32_t, 2>;

  int count_;
  std::vector<Point> points_;  // [net][purpose][index]
};

/// Two unit vectors that make a right-handed frame with the unit vector `axis`.
struct Frame {
  explicit Frame(Vec3 axis);
  Vec3 out(double x, double y, double z) const { return x * tangent + y * bitangent + z * normal; }

  Vec3 tangent, bitangent, normal;
};

/// A direction about the frame's normal with density cos / pi.
Vec3 cosine_direction(const Frame& frame, Sample2 sample);
/// A direction of the cone about the frame's normal, uniform in solid angle.
Vec3 cone_direction(const Frame& frame, double cos_half_angle, Sample2 sample);

}  // namespace toile
