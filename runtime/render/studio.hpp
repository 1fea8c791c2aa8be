// The light of the studio: a large key light, a dome with a lighter rim behind the subject, and a backdrop that the
// floor runs into without a line.
#pragma once

#include "runtime/mesh/vec3.hpp"
#include "runtime/render/camera.hpp"
#include "runtime/render/colour.hpp"

namespace toile {

/// Radiances are scaled so that a white matte surface that faces the camera is about 1.
class Studio {
 public:
  /// The lights stand with the camera: key at its upper left, rim behind on the right.
  explicit Studio(const Aim& aim);
  /// Uniform white light from everywhere, for tests: what is white disappears in it.
  static Studio furnace();

  Vec3 key_direction() const { return key_; }
  double key_cos_half_angle() const { return key_cos_; }
  /// On a surface at right angles to it.
  Rgb key_irradiance() const { return key_irradiance_; }
  /// From afar in a unit direction; below the horizon it is the floor's.
  Rgb dome(Vec3 direction) const;
  /// The radiance of a white surface in the midst of others: what light is worth that would have to be followed
  /// through more reflections.
  double nook() const { return nook_; }

 private:
  Studio() = default;

  Vec3 key_{0, 0, 1}, rim_{0, 0, 1};
  double key_cos_ = 1;
  Rgb key_irradiance_;
  Rgb sky_low_, sky_high_, floor_;
  double rim_strength_ = 0;
  double nook_ = 0;
};

/// The lit backdrop at a place of the picture (0 … 1 from the top left).
Rgb backdrop(double x, double y);

}  // namespace toile
