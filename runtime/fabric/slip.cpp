#include "runtime/fabric/slip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace toile {
namespace {

double limit_at(const Slip& slip, double deformation) {
  return slip.limit + slip.growth * std::min(std::abs(deformation), slip.end);
}

double force_at(const Slip& slip, double anchor, double deformation) {
  const double u = std::clamp((deformation - anchor) / slip.scale, -1.0, 1.0);
  return limit_at(slip, deformation) * u * (2 - std::abs(u));
}

/// The force is a polynomial of the third degree between the places where it changes its law: two points of Gauss.
double work(const Slip& slip, double anchor, double deformation) {
  std::array<double, 7> stops{anchor, -slip.end, 0, slip.end, anchor - slip.scale, anchor + slip.scale, deformation};
  for (double& stop : stops) {
    stop = std::clamp(stop, std::min(anchor, deformation), std::max(anchor, deformation));
  }
  std::sort(stops.begin(), stops.end());
  double sum = 0;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const double middle = 0.5 * (stops[i] + stops[i + 1]), half = 0.5 * (stops[i + 1] - stops[i]);
    const double off = half / std::sqrt(3.0);
    if (half > 0) sum += half * (force_at(slip, anchor, middle - off) + force_at(slip, anchor, middle + off));
  }
  return deformation < anchor ? -sum : sum;
}

}  // namespace

Density slip_density(const Slip& slip, double anchor, double deformation) {
  const double u = std::clamp((deformation - anchor) / slip.scale, -1.0, 1.0);
  Density density{work(slip, anchor, deformation), force_at(slip, anchor, deformation), 0};
  density.stiffness = limit_at(slip, deformation) * 2 * (1 - std::abs(u)) / slip.scale;
  if (std::abs(deformation) < slip.end) {
    density.stiffness += (deformation < 0 ? -slip.growth : slip.growth) * u * (2 - std::abs(u));
  }
  return density;
}

double anchor_after(const Slip& slip, double anchor, double deformation) {
  return deformation - std::clamp(deformation - anchor, -slip.scale, slip.scale);
}

}  // namespace toile
