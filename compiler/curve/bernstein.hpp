// Polynomials on [0, 1] by their Bernstein coefficients, in which the control points of a Bézier stand.
#pragma once

#include <vector>

namespace toile {

using Bernstein = std::vector<double>;

Bernstein operator*(const Bernstein& a, const Bernstein& b);
/// Of one degree.
Bernstein operator+(const Bernstein& a, const Bernstein& b);

/// The roots in [0, 1], ascending, each once; where the polynomial touches zero without crossing it counts as well.
/// None for a polynomial that is zero everywhere.
std::vector<double> roots(const Bernstein& polynomial);

}  // namespace toile
