// A smooth curve for a line of solved points, as a person would draw it: straight where it is straight, else by as few
// points as the tolerance allows.
#pragma once

#include <optional>
#include <vector>

#include "compiler/curve/curve.hpp"

namespace toile {

struct FittedCurve {
  std::vector<Vec2> points;                 // first, those it goes through, last; to a micrometre
  std::optional<double> leaving, arriving;  // [rad]; none for a straight line
  Curve curve;
  double error = 0;  // [m] the farthest that one of the solved points lies from it
  bool straight() const { return !leaving; }
};

/// The ends are met. `tolerance` [m] is kept unless every solved point is on the curve already.
FittedCurve fit_curve(const std::vector<Vec2>& solved, double tolerance);

/// To a micrometre, so that a text says exactly what was checked.
Vec2 rounded(Vec2 point);

}  // namespace toile
