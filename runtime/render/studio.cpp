#include "runtime/render/studio.hpp"

#include <cmath>
#include <numbers>

namespace toile {

Studio::Studio(const Aim& aim) {
  const Vec3 up{0, 0, 1};
  const Vec3 right = cross(aim.ahead, up);
  // The more the camera looks down, the higher the key, lest shadows grow as long as the subject is tall.
  const double height = 0.72 + 1.1 * aim.forward.z * aim.forward.z;
  key_ = normalized(-0.50 * aim.ahead - 0.70 * right + height * up);
  key_cos_ = std::cos(13 * std::numbers::pi / 180);
  key_irradiance_ = std::numbers::pi * Rgb{1.24, 1.20, 1.14};
  rim_ = normalized(0.62 * aim.ahead + 0.70 * right + 0.35 * up);
  rim_strength_ = 0.8;
  sky_low_ = {0.26, 0.27, 0.29};
  sky_high_ = {0.52, 0.54, 0.57};
  floor_ = {0.27, 0.265, 0.26};
  nook_ = 0.34;
}

Studio Studio::furnace() {
  Studio studio;
  studio.sky_low_ = studio.sky_high_ = studio.floor_ = grey(1);
  studio.nook_ = 1;
  return studio;
}

Rgb Studio::dome(Vec3 direction) const {
  if (direction.z < 0) return floor_;
  const double facing = dot(direction, rim_);
  const double rim = facing > 0 ? rim_strength_ * facing * facing * facing * facing : 0;
  return mix(sky_low_, sky_high_, direction.z) + grey(rim);
}

Rgb backdrop(double x, double y) {
  const double dx = x - 0.5;
  const double dy = y - 0.46;
  const double fall = std::min(1.0, 1.6 * (dx * dx + dy * dy));
  return mix(Rgb{0.845, 0.840, 0.830}, Rgb{0.600, 0.605, 0.610}, fall * (1.6 - 0.6 * fall));
}

}  // namespace toile
