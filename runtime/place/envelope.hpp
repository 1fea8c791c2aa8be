// The surface on which a hanging cloth is laid out to start with: rings around a limb, one below the other, outside the
// body.
#pragma once

#include <vector>

#include "runtime/place/fullness.hpp"
#include "runtime/place/line_curve.hpp"

namespace toile {

/// Generators start at the line, one for each part of it, and go on by equal steps within their own half plane through
/// the axis: along the limb and as much outwards as the turns grow, so that without a body in the way a flared cloth
/// lies on a cone without any strain. Where the body is in the way they slide along it, and their neighbours lean out
/// with them, as a taut cloth would.
class Envelope {
 public:
  Envelope(const BodyLine& line, const ClosedCurve& start, const Fullness& fullness, const Body& body,
           double clearance);
  /// At a depth along the generators [m] and a fraction of the ring's length from the front.
  Vec3 at(double depth, double fraction) const;

 private:
  double step_ = 0;  // [m] between rings
  std::vector<ClosedCurve> rings_;
};

}  // namespace toile
