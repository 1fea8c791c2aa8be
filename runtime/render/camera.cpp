#include "runtime/render/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace toile {
namespace {

/// Angles in degrees: about z from the front (-y) towards the wearer's left (+x), and above the horizon.
Aim from(double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180;
  const double e = elevation * std::numbers::pi / 180;
  const Vec3 ahead{-std::sin(a), std::cos(a), 0};
  const Vec3 right = cross(ahead, {0, 0, 1});
  const Vec3 forward = std::cos(e) * ahead + Vec3{0, 0, -std::sin(e)};
  return {forward, right, cross(right, forward), ahead};
}

/// The extent of the points in one direction of the picture, as seen through a lens of half angle atan(k): where the
/// axis must pass and how far back the eye must stand.
struct Fit {
  double low = std::numeric_limits<double>::infinity();    // of (offset + k depth)
  double high = -std::numeric_limits<double>::infinity();  // of (offset - k depth)

  void add(double offset, double depth, double k) {
    high = std::max(high, offset - k * depth);
    low = std::min(low, offset + k * depth);
  }
  double centre() const { return (high + low) / 2; }
  double back(double k) const { return (high - low) / (2 * k); }
};

}  // namespace

Aim aim(View view) {
  switch (view) {
    case View::Front:
      return from(0, 5);
    case View::Back:
      return from(180, 5);
    case View::Left:
      return from(90, 5);
    case View::Right:
      return from(-90, 5);
    case View::Above:
      return {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
    case View::ThreeQuarter:
      break;
  }
  return from(32, 12);
}

Camera::Camera(const Aim& aim, const Viewport& viewport, const std::vector<Vec3>& points, double margin)
    : aim_(aim), centre_x_(viewport.left + viewport.width / 2), centre_y_(viewport.top + viewport.height / 2) {
  constexpr double kHalfFilm = 12.0;  // [mm] half the short side
  constexpr double kFocal = 85.0;     // [mm]
  const double k = kHalfFilm / kFocal;
  pixel_ = 2 * k / std::min(viewport.width, viewport.height);
  const double kx = (1 - 2 * margin) * pixel_ * viewport.width / 2;
  const double ky = (1 - 2 * margin) * pixel_ * viewport.height / 2;

  Fit across;
  Fit upright;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& p : points) {
    const double depth = dot(p, aim.forward);
    across.add(dot(p, aim.right), depth, kx);
    upright.add(dot(p, aim.up), depth, ky);
    nearest = std::min(nearest, depth);
  }
  if (points.empty()) {
    eye_ = (-1 / k) * aim.forward;
    return;
  }
  // A single point would let the eye sit in it.
  const double back = std::max({across.back(kx), upright.back(ky), 1e-3 - nearest});
  eye_ = across.centre() * aim.right + upright.centre() * aim.up - back * aim.forward;
}

Ray Camera::ray(double x, double y) const {
  const Vec3 direction = aim_.forward + (pixel_ * (x - centre_x_)) * aim_.right - (pixel_ * (y - centre_y_)) * aim_.up;
  return {eye_, normalized(direction)};
}

Vec2 Camera::project(Vec3 point) const {
  const Vec3 offset = point - eye_;
  const double scale = 1 / (pixel_ * dot(offset, aim_.forward));
  return {centre_x_ + scale * dot(offset, aim_.right), centre_y_ - scale * dot(offset, aim_.up)};
}

}  // namespace toile
