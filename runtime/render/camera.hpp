// A long lens that frames what it is shown.
#pragma once

#include <vector>

#include "runtime/render/ray_scene.hpp"
#include "runtime/render/render.hpp"

namespace toile {

/// Where a view looks, and which way is right and up in the picture: an orthonormal, right-handed triple.
struct Aim {
  Vec3 forward, right, up;
  Vec3 ahead;  // horizontal: away from the camera in the sense of the lights
};

/// Front is seen from -y, left from the wearer's left (+x), above from above with the front at the bottom; level views
/// look down a little, so that there is a floor.
Aim aim(View view);

/// The part of the picture that the subject shall fill, in pixels.
struct Viewport {
  double left = 0, top = 0, width = 1, height = 1;
};

class Camera {
 public:
  /// As near as the lens (85 mm on 36 x 24 mm film, along the shorter side of the viewport) allows with every point
  /// inside the viewport less `margin` (a fraction of its size, each side).
  Camera(const Aim& aim, const Viewport& viewport, const std::vector<Vec3>& points, double margin);

  /// Through a place of the picture, in pixels from the top left corner. The direction is a unit vector.
  Ray ray(double x, double y) const;
  /// Where a point in front of the camera appears, in pixels.
  Vec2 project(Vec3 point) const;
  /// The width of a pixel at unit depth.
  double pixel() const { return pixel_; }
  const Aim& aim() const { return aim_; }

 private:
  Aim aim_;
  double centre_x_ = 0, centre_y_ = 0;  // of the viewport [pixel]
  double pixel_ = 1;
  Vec3 eye_;
};

}  // namespace toile
