// A slope for tests of contact.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "runtime/body/body.hpp"

namespace toile::test {

/// A half space below a plane through the origin, tilted about y.
class Incline : public Body {
 public:
  Incline(double tilt, double friction) : normal_{std::sin(tilt), 0, std::cos(tilt)} { spec_.friction = friction; }
  const BodySpec& spec() const override { return spec_; }
  const Surface& surface() const override { return surface_; }
  const std::vector<BodyLine>& lines() const override { return lines_; }
  Vec3 top() const override { return {}; }
  std::optional<SurfacePoint> nearest(Vec3 p, double reach) const override {
    const double distance = dot(p, normal_);
    if (distance > reach) return std::nullopt;
    return SurfacePoint{p - distance * normal_, normal_, distance, 0};
  }

 private:
  BodySpec spec_;
  Surface surface_;
  std::vector<BodyLine> lines_;
  Vec3 normal_;
};

}  // namespace toile::test
