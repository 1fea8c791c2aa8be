// What a drape comes to, in plain numbers: what the report prints and what a script's `expect` and `print` may ask for.
#pragma once

#include "runtime/export/export.hpp"

namespace toile {

struct Summary {
  // mesh
  Topology topology;
  double edge_min_m = 0, edge_mean_m = 0, edge_max_m = 0;  // edges of the sewn surface at rest in the pattern
  double area_m2 = 0;                                      // of the cut cloth, seams closed
  // solve, contact: as drape() found them
  bool converged = false;
  std::string trouble;
  int iterations = 0;
  double residual_N = 0, residual_moment_Nm = 0, residual_relative = 0;
  Energies energy_J;
  Contact contact;
  // shape
  int intersecting_triangle_pairs = 0;
  int folds = 0;                 // of the lowest free boundary loop; 0 without one
  double projected_area_m2 = 0;  // seen from above
  // strains [1], shear angle [rad]; forces per width [N/m]; weighted by area in the P-mesh
  struct Directions {
    Spread warp, weft, shear;
  };
  Directions strain;
  Directions stress_N_per_m;
};

Summary summarise(const DrapedGarment& draped);

}  // namespace toile
