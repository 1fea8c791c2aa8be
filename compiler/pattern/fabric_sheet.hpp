// A cloth's measured properties as the script states them, in SI.
#pragma once

#include <optional>
#include <string>

#include "grammar/source.hpp"

namespace toile {

struct WarpWeft {
  double warp = 0;
  double weft = 0;
};

/// The KES-FB sheet (Kawabata Evaluation System), or for a group of its rows the FAST chart (De Boos and Tester,
/// SiroFAST, 1994). Absent rows take class values in runtime/fabric; weight and bending must be there. Of the two
/// instruments' rows for one property never both are set. Values are SI: see the unit behind each.
struct FabricSheet {
  std::string name;
  std::string source;  // where the measured rows were published
  // tensile, to Fm = 500 gf/cm
  std::optional<WarpWeft> lt;   // LT, linearity [1]
  std::optional<WarpWeft> wt;   // WT, work [J/m2]
  std::optional<WarpWeft> rt;   // RT, resilience [1] (0.6 for 60 %)
  std::optional<WarpWeft> emt;  // EMT, elongation at Fm [1] (0.05 for 5 %)
  // shear
  std::optional<WarpWeft> g;    // G [N/m per rad]
  std::optional<WarpWeft> hg;   // 2HG, hysteresis at 0.5 deg [N/m]
  std::optional<WarpWeft> hg5;  // 2HG5, hysteresis at 5 deg [N/m]
  // bending
  std::optional<WarpWeft> b;    // B [N m] (moment per width and curvature: N m2/m)
  std::optional<WarpWeft> hb;   // 2HB [N] (moment per width: N m/m)
  std::optional<double> twist;  // D66 [N m], not on the sheet: default half the geometric mean of B
  std::optional<double> b45;    // B of a strip cut on the bias [N m], not on the sheet: says the twist
  // compression and surface
  std::optional<double> lc, wc, rc;     // LC [1], WC [J/m2], RC [1]
  std::optional<double> t0, tm;         // thickness at 49 Pa and 4.9 kPa [m]
  std::optional<double> miu, mmd, smd;  // friction [1], its deviation [1], roughness [m]
  std::optional<double> weight;         // W [kg/m2]
  // plain engineering constants, instead of the tensile and shear rows: linear, the same in tension and compression
  std::optional<WarpWeft> stretch;  // [N/m] per unit strain
  std::optional<double> shear;      // [N/m] per rad
  // FAST and Peirce's cantilever
  std::optional<WarpWeft> e5, e20, e100;  // E5, E20, E100: elongation [1] at 5, 20 and 100 gf/cm
  std::optional<double> eb5;              // EB5: elongation [1] on the bias at 5 gf/cm
  std::optional<WarpWeft> c;              // C: bending length [m]; its rigidity contains the friction
  std::optional<double> c45;              // C of a strip cut on the bias [m]
  std::optional<double> t2, t100;         // T2, T100: thickness [m] at 2 and 100 gf/cm2
  int plies = 1;                          // that lie on each other, sewn as one: what the rows say is of a single one
  Location written;
};

}  // namespace toile
