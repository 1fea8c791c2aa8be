#include "runtime/drape/spread.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace toile {

Spread spread(const std::vector<double>& values, const std::vector<double>& areas) {
  if (values.empty()) return {};
  std::vector<double> weights(values.size(), 0.0);
  for (std::size_t i = 0; i < std::min(values.size(), areas.size()); ++i) weights[i] = std::max(areas[i], 0.0);
  double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(total > 0)) {  // without areas every value counts alike
    weights.assign(values.size(), 1.0);
    total = static_cast<double>(values.size());
  }

  Spread result;
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  result.min = *least;
  result.max = *greatest;
  result.mean = std::inner_product(values.begin(), values.end(), weights.begin(), 0.0) / total;

  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return std::abs(values[a]) < std::abs(values[b]); });
  double below = 0;
  for (const std::size_t i : order) {
    below += weights[i];
    result.p95 = std::abs(values[i]);
    if (below >= 0.95 * total) break;
  }
  return result;
}

}  // namespace toile
