// Friction inside a cloth that remembers: a spring from an anchor, which slips where it reaches its limit. By it the
// loops of shear and bending close as they do on the KES instruments.
#pragma once

namespace toile {

/// An energy density and its derivatives by the deformation.
struct Density {
  double energy = 0;
  double force = 0;
  double stiffness = 0;
};

struct Slip {
  double scale = 0;   // the way from the anchor at which it slips
  double limit = 0;   // the force it slips at, in the undeformed cloth
  double growth = 0;  // of the limit with the size of the deformation …
  double end = 0;     // … up to this one
};

/// With u the way from the anchor over the scale, the force is 2u - u^2 of the limit, and the limit from u = 1 on.
Density slip_density(const Slip& slip, double anchor, double deformation);
/// The anchor follows a deformation that has slipped.
double anchor_after(const Slip& slip, double anchor, double deformation);

/// What one triangle remembers: the anchors of its frictions.
struct ClothMemory {
  double shear = 0;                     // [rad]
  double bend_warp = 0, bend_weft = 0;  // [1/m]
};

}  // namespace toile
