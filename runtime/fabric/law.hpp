// Constitutive laws of a cloth, from its KES sheet. Energies are per area of undeformed cloth [J/m2]; every law gives
// the energy and its first two derivatives. The curves are those of docs/mechanics.md.
#pragma once

#include "compiler/pattern/fabric_sheet.hpp"
#include "runtime/fabric/slip.hpp"

namespace toile {

/// Elongation along a thread, F(e) = Fm (exp(z e/em) - 1)/(exp(z) - 1) up to em, then straight on; under compression a
/// tenth of the initial slope (the sheet buckles instead). A linear law acts both ways.
class ElongationLaw {
 public:
  /// From the sheet: elongation em [1] at Fm = 490.33 N/m and linearity LT [1].
  static ElongationLaw from_kes(double emt, double lt);
  static ElongationLaw linear(double stiffness);  // [N/m]

  Density operator()(double strain) const;
  /// The same with so much of its force: a share, or as many times as it has plies.
  ElongationLaw softened(double share) const;
  double initial_stiffness() const { return initial_; }

 private:
  Density stretched(double strain) const;

  double initial_ = 0;      // [N/m] slope at rest
  double compression_ = 0;  // [N/m] slope under compression
  double exponent_ = 0;     // z; 0 for a straight line
  double limit_ = 0;        // em
  double scale_ = 0;        // Fm / (exp(z) - 1)
  double top_ = 0;          // [N/m] slope at the end of the blend
  double shift_force_ = 0;  // keeps force and energy continuous past the blend about zero
  double shift_energy_ = 0;
};

/// Shear by the angle phi [rad] between the threads, with the loading branch of the hysteresis loop and stiffening
/// beyond 8 degrees towards locking.
class ShearLaw {
 public:
  ShearLaw(double stiffness, double hysteresis_half_degree, double hysteresis_five_degrees, double locking_angle);
  /// On the loading branch; with an anchor of its friction, anywhere in the loop.
  Density operator()(double angle) const;
  Density operator()(double angle, double anchor) const;
  Slip loop() const;
  static ShearLaw linear(double stiffness);
  /// The same with so much of its force.
  ShearLaw softened(double share) const;

 private:
  Density jammed(Density density, double angle) const;
  Density past_loop(Density density, double angle) const;

  double stiffness_ = 0;  // [N/m per rad]
  double step_ = 0;       // [N/m] friction of the loop, extrapolated to zero angle
  double slope_ = 0;      // [N/m per rad] growth of the loop, taken off G past its end
  double locking_ = 0;    // [rad]; 0: none
};

/// Moment per width B k + HB k/sqrt(k^2 + d^2), the loading branch smoothed about zero.
struct BendingLaw {
  double rigidity = 0;  // B [N m]
  double friction = 0;  // HB [N]
  Density operator()(double curvature) const;
  Density operator()(double curvature, double anchor) const;
  Slip loop() const;
};

/// On the loading branch where there is no anchor.
template <class Law>
Density density(const Law& law, double deformation, const double* anchor) {
  return anchor != nullptr ? law(deformation, *anchor) : law(deformation);
}

struct FabricLaw {
  ElongationLaw warp, weft;
  ShearLaw shear;
  BendingLaw bend_warp, bend_weft;
  double twist = 0;      // D66 [N m]
  double weight = 0;     // [kg/m2]
  double thickness = 0;  // [m]
  double pressure = 0;   // [Pa] scale of what presses two layers together, see SelfContact
  double friction = 0;   // [1] against the body
};

/// The rows of FAST and of the cantilever as those of the KES: what the laws are made of.
FabricSheet in_kes_rows(FabricSheet sheet);
/// The sheet with the class values of docs/mechanics.md in the rows that are missing (weight and bending are asked for
/// by the compiler).
FabricSheet with_class_values(FabricSheet sheet);
/// Missing rows take class values.
FabricLaw make_law(const FabricSheet& sheet);

/// The same cloth, but with so much of its forces of elongation and shear.
FabricLaw softened(const FabricLaw& law, double share);

}  // namespace toile
