// FAST (De Boos and Tester, SiroFAST: Fabric Assurance by Simple Testing, CSIRO 1994) and Peirce's cantilever (The
// Handle of Cloth as a Measurable Quantity, 1930), told as rows of the KES.
#include <cmath>

#include "runtime/fabric/law.hpp"

namespace toile {
namespace {

constexpr double gram_force_per_cm = 0.980665;  // [N/m]
constexpr double gravity = 9.80665;             // [m/s2]

struct Tension {
  double emt = 0, lt = 0;
};

/// The curve F(e) = k (exp(a e) - 1) of the KES through the elongations at 20 and at 100 gf/cm, drawn on to 500. The
/// compiler sees to e20 < e100 <= 5 e20; at five times it is a straight line, of which the law's exponent stays small.
Tension tension_through(double e20, double e100) {
  const double share = e20 / e100;
  const auto ratio = [share](double y) { return std::expm1(y) / std::expm1(y * share); };
  double low = 1e-6, high = 200;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (ratio(middle) < 5 ? low : high) = middle;
  }
  const double y = 0.5 * (low + high);
  const double z = std::log1p(5 * std::expm1(y));  // F(EMT) = 5 F(e100)
  return {.emt = z / y * e100, .lt = 2 / z - 2 / std::expm1(z)};
}

/// Peirce: B = W g C^3.
double rigidity(double weight, double length) {
  return weight * gravity * length * length * length;
}

/// A narrow strip on the bias is free to curve across, so its compliances add: 4/B45 = 1/B(warp) + 1/B(weft) + 1/D66.
double twist_from_bias(double b45, const WarpWeft& b) {
  return 1 / (4 / b45 - 1 / b.warp - 1 / b.weft);
}

}  // namespace

FabricSheet in_kes_rows(FabricSheet sheet) {
  if (sheet.e20 && sheet.e100) {
    const Tension warp = tension_through(sheet.e20->warp, sheet.e100->warp);
    const Tension weft = tension_through(sheet.e20->weft, sheet.e100->weft);
    sheet.emt = WarpWeft{warp.emt, weft.emt};
    sheet.lt = WarpWeft{warp.lt, weft.lt};
  }
  if (sheet.eb5) {
    // Pulled on the bias by 5 gf/cm the threads turn by twice what the strip lengthens, each half the load's work.
    const double stiffness = 5 * gram_force_per_cm / (4 * *sheet.eb5);
    sheet.g = WarpWeft{stiffness, stiffness};
  }
  if (sheet.c && sheet.weight)
    sheet.b = {rigidity(*sheet.weight, sheet.c->warp), rigidity(*sheet.weight, sheet.c->weft)};
  if (sheet.c45 && sheet.weight) sheet.b45 = rigidity(*sheet.weight, *sheet.c45);
  if (sheet.b45 && sheet.b && !sheet.twist) sheet.twist = twist_from_bias(*sheet.b45, *sheet.b);
  if (sheet.t2) sheet.t0 = sheet.t2;
  if (sheet.t100) sheet.tm = sheet.t100;
  return sheet;
}

}  // namespace toile
