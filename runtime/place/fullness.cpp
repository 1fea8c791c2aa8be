#include "runtime/place/fullness.hpp"

#include <algorithm>

#include "runtime/place/winding.hpp"

namespace toile {

double Fullness::turn_at(double at) const {
  const double x = std::clamp(at / bin - 0.5, 0.0, static_cast<double>(turn.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(x), turn.size() - 1);
  const std::size_t j = std::min(i + 1, turn.size() - 1);
  const double t = x - static_cast<double>(i);
  return (1 - t) * turn[i] + t * turn[j];
}

Fullness measure_fullness(const RestMesh& rest, const std::vector<double>& fraction, const std::vector<double>& depth,
                          const std::vector<bool>& own, double at_chain) {
  Fullness fullness;
  for (std::size_t v = 0; v < own.size(); ++v) {
    if (own[v]) fullness.depth = std::max(fullness.depth, depth[v]);
  }
  fullness.bin = std::max(1.5 * rest.mean_edge(), fullness.depth / 200);
  const int bins = static_cast<int>(fullness.depth / fullness.bin) + 1;
  const std::vector<double> rough = turn_lengths(rest, fraction, depth, own, fullness.bin, bins, at_chain);
  for (int i = 0; i < bins; ++i) {
    const int reach = std::min({2, i, bins - 1 - i});
    double sum = 0;
    for (int j = i - reach; j <= i + reach; ++j) sum += rough[j];
    fullness.turn.push_back(sum / (2 * reach + 1));
  }
  return fullness;
}

}  // namespace toile
