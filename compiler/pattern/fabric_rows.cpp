#include "compiler/pattern/fabric_rows.hpp"

#include <numbers>

namespace toile {

const std::vector<FabricRow>& fabric_rows() {
  using S = FabricSheet;
  constexpr double gram_force = 0.00980665;  // [N]
  constexpr double degree = std::numbers::pi / 180;
  static const std::vector<FabricRow> rows{
      {"LT", "1", 1, &S::lt, 0.01, 3},
      {"WT", "gf*cm/cm^2", 100 * gram_force, &S::wt, 1e-3, 1e3},
      {"RT", "%", 0.01, &S::rt, 0, 1},
      {"EMT", "%", 0.01, &S::emt, 1e-5, 5},
      {"G", "gf/cm/deg", 100 * gram_force / degree, &S::g, 1e-3, 1e5},
      {"2HG", "gf/cm", 100 * gram_force, &S::hg, 0, 1e3},
      {"2HG5", "gf/cm", 100 * gram_force, &S::hg5, 0, 1e3},
      {"B", "gf*cm^2/cm", 0.01 * gram_force, &S::b, 1e-9, 1},
      {"2HB", "gf*cm/cm", gram_force, &S::hb, 0, 10},
      {"twist", "gf*cm^2/cm", 0.01 * gram_force, &S::twist, 0, 1},
      {"LC", "1", 1, &S::lc, 0, 3},
      {"WC", "gf*cm/cm^2", 100 * gram_force, &S::wc, 0, 1e2},
      {"RC", "%", 0.01, &S::rc, 0, 1},
      {"T0", "mm", 1e-3, &S::t0, 1e-6, 0.1},
      {"Tm", "mm", 1e-3, &S::tm, 1e-6, 0.1},
      {"W", "mg/cm^2", 0.01, &S::weight, 1e-4, 20},
      {"MIU", "1", 1, &S::miu, 0, 5},
      {"MMD", "1", 1, &S::mmd, 0, 5},
      {"SMD", "um", 1e-6, &S::smd, 0, 1e-2},
      {"stretch", "N/m", 1, &S::stretch, 1e-1, 1e9},
      {"shear", "N/m", 1, &S::shear, 1e-3, 1e8},
      {"B45", "gf*cm^2/cm", 0.01 * gram_force, &S::b45, 1e-9, 1},
      {"E5", "%", 0.01, &S::e5, 0, 5},
      {"E20", "%", 0.01, &S::e20, 1e-5, 5},
      {"E100", "%", 0.01, &S::e100, 1e-5, 5},
      {"EB5", "%", 0.01, &S::eb5, 1e-5, 5},
      {"C", "mm", 1e-3, &S::c, 1e-4, 0.5},
      {"C45", "mm", 1e-3, &S::c45, 1e-4, 0.5},
      {"T2", "mm", 1e-3, &S::t2, 1e-6, 0.1},
      {"T100", "mm", 1e-3, &S::t100, 1e-6, 0.1},
  };
  return rows;
}

}  // namespace toile
