// A line of the body as a curve to hang cloth on.
#pragma once

#include <vector>

#include "runtime/body/body.hpp"

namespace toile {

/// A closed polyline parametrised by fractions of its length.
class ClosedCurve {
 public:
  explicit ClosedCurve(std::vector<Vec3> points);
  double length() const { return arc_.back(); }
  /// Fractions are taken modulo one.
  Vec3 at(double fraction) const;
  /// Where the curve is nearest to p.
  double fraction_near(Vec3 p) const;
  const std::vector<Vec3>& points() const { return points_; }

 private:
  std::vector<Vec3> points_;
  std::vector<double> arc_;  // at each point, and at the first once more
};

/// The line moved outwards across its axis by a constant distance; grows by 2 pi times it where it is convex.
ClosedCurve offset(const BodyLine& line, double distance);

/// The outward directions, across the axis, at a line's points.
std::vector<Vec3> outward_directions(const BodyLine& line);

/// The line itself, or, when `length` [m] is more than its girth, moved outwards until it is as long.
ClosedCurve scaled(const BodyLine& line, double length);

}  // namespace toile
