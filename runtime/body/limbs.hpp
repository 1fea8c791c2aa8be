// Limbs of a dress form: stumps of arms grown out of the trunk's grid, legs below its division.
#pragma once

#include <optional>
#include <vector>

#include "runtime/body/trunk.hpp"

namespace toile {

/// A limb of the left half: its first ring, from its front, and the direction in which it goes.
struct Limb {
  std::vector<int> root;
  Vec3 axis;
};

/// Where the stump of an arm leaves the trunk: below the shoulder point, as high and wide as the root's girth asks for.
/// None when the trunk has no shoulder or no room below it.
std::optional<Opening> armhole(const Trunk& trunk, const BodyLimb& arm, const HalfForm& form);

/// The stump over that opening. Its root ring lies in the plane of the armhole, a little outside the trunk, and has the
/// girth asked for; on its way the stump turns to its axis. What lies between trunk and root is free for fairing.
Limb grow_arm(const Trunk& trunk, const Opening& opening, const BodyLimb& arm, HalfForm& form);

/// The trunk's lowest ring and the saddle between the legs as one loop about the left leg: the half ring from the front
/// to the back centre, and back along the saddle.
struct Saddle {
  std::vector<int> loop;
  std::vector<int> seam;  // the vertices between the back and the front centre, x = 0
};
Saddle hang_saddle(const Trunk& trunk, HalfForm& form);

/// The leg below the saddle; its root ring has the girth asked for.
Limb grow_leg(const Saddle& saddle, const BodyLimb& leg, HalfForm& form);

}  // namespace toile
