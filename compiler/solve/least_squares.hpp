// Several unknowns at once: the values within their ranges that bring all residuals nearest to zero.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace toile {

/// The residuals at a place, or nothing where they have no value. Always as many, scaled so that 1 is far from solved.
using Residuals = std::function<std::optional<std::vector<double>>(const std::vector<double>&)>;

struct Range {
  double low = 0;
  double high = 0;
};

struct Fit {
  std::vector<double> at;         // one value an unknown, each in its range
  std::vector<double> residuals;  // there
  double cost = 0;                // the sum of their squares
};

/// Levenberg-Marquardt steps within the ranges, begun in the middle and, as long as some residual stays above
/// `tolerance`, at other places in a fixed order. Gives the best place found; nothing when none had a value.
std::optional<Fit> least_squares(const Residuals& residuals, const std::vector<Range>& ranges, double tolerance);

}  // namespace toile
