// Monotone piecewise cubic interpolation: no overshoot between the values given, one continuous derivative.
#pragma once

#include <vector>

namespace toile {

/// Slopes by Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5, 1984): weighted harmonic means of the secants, zero
/// where they change sign; one-sided at the ends.
class MonotoneCubic {
 public:
  /// `x` strictly increasing, at least two of them, `y` as many.
  MonotoneCubic(std::vector<double> x, std::vector<double> y);
  /// Constant beyond the ends.
  double at(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace toile
