// A leg of the body from above the fork down, as rings about its middle: where the cloth around it is laid out.
#pragma once

#include <vector>

#include "runtime/body/body.hpp"

namespace toile {

/// Directions across a leg. Fractions of a turn run counter-clockwise seen against the axis, as lines of the body do.
struct LegFrame {
  Vec3 axis;            // down the leg
  Vec3 forward, aside;  // unit, across the axis, at the fractions 0 and a quarter
  explicit LegFrame(Vec3 down);
  double level(Vec3 p) const { return dot(p, axis); }  // [m] grows down the leg
  Vec3 outwards(double fraction) const;
};

/// Cloth that belongs to one leg stays on its side of this plane.
struct Divide {
  Vec3 point;
  Vec3 away;  // unit normal, towards the other leg
};

/// Rings at even levels, each about the middle of the body's section there that lies on this side of the divide: half
/// of the trunk above the fork, the leg below it. The middle is followed downwards from ring to ring, so it keeps
/// within a leg that is not straight; below the leg's end the last ring goes on along the axis.
class LegRings {
 public:
  LegRings(const Body& body, const LegFrame& frame, const std::vector<Divide>& divides, Vec3 start, double top,
           double bottom, double clearance);

  const LegFrame& frame() const { return frame_; }
  /// The fraction of a turn at which p is seen from the middle of its level.
  double fraction_of(Vec3 p) const;
  /// A point at a level, outside the body by the clearance and by `slack` more, on its side of the divides.
  Vec3 at(double level, double fraction, double slack) const;
  /// Round the leg at that level.
  double girth(double level) const;

 private:
  struct Ring {
    Vec3 middle;
    std::vector<double> radius;
  };
  Ring measured(const Body& body, Vec3 middle) const;
  double room(Vec3 middle, Vec3 direction) const;
  Vec3 on_ring(const Ring& ring, double fraction, double slack) const;
  std::size_t index(double level) const;

  LegFrame frame_;
  std::vector<Divide> divides_;
  double clearance_;
  double top_;
  std::vector<Ring> rings_;
};

}  // namespace toile
