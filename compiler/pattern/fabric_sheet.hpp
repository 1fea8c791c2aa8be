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

/// The KES-FB sheet (Kawabata Evaluation System). Absent rows take class values in runtime/fabric; weight and bending
/// must be there. Values are SI: see the unit behind each.
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
  // compression and surface
  std::optional<double> lc, wc, rc;     // LC [1], WC [J/m2], RC [1]
  std::optional<double> t0, tm;         // thickness at 49 Pa and 4.9 kPa [m]
  std::optional<double> miu, mmd, smd;  // friction [1], its deviation [1], roughness [m]
  std::optional<double> weight;         // W [kg/m2]
  // plain engineering constants, instead of the tensile and shear rows: linear, the same in tension and compression
  std::optional<WarpWeft> stretch;  // [N/m] per unit strain
  std::optional<double> shear;      // [N/m] per rad
  Location written;
};

}  // namespace toile
