// How finely a bundle of sewn stretches is divided before any triangle asks for more.
#pragma once

#include <vector>

#include "compiler/curve/curve.hpp"

namespace toile {

struct SpacingMember {
  const Curve* curve = nullptr;
  double from = 0, to = 0;  // [m]
  bool forward = true;
};

struct SpacingBounds {
  double edge = 0;         // [m] longest side
  double chord_error = 0;  // [m]
  int least = 1;           // sides
};

/// Fractions 0 = t0 < … < 1 such that no member has a side much longer than the bound, nor a chord that strays
/// further from its curve; the sides' lengths change gradually.
std::vector<double> divide_alike(const std::vector<SpacingMember>& members, const SpacingBounds& bounds);

}  // namespace toile
