// The light that a place sends to the camera, estimated with one ray to the key light and one to the dome.
#pragma once

#include "runtime/render/samples.hpp"
#include "runtime/render/stage.hpp"
#include "runtime/render/studio.hpp"

namespace toile {

/// One sample: colour and light are kept apart, so that noise in the light can be smoothed without touching the
/// textile. What the camera sees is their product.
struct Shaded {
  Rgb colour;
  Rgb light;
};

class Shading {
 public:
  Shading(const Stage& stage, const Studio& studio) : stage_(stage), studio_(studio) {}

  Shaded actor(const Spot& spot, Vec3 to_viewer, Sample2 key, Sample2 dome) const;
  /// The share of its light that a place of the floor keeps among the actors.
  Rgb floor(Vec3 position, Sample2 key, Sample2 dome) const;

 private:
  Rgb incoming(const Ray& ray) const;
  Rgb colour(const Spot& spot) const;

  const Stage& stage_;
  const Studio& studio_;
};

}  // namespace toile
