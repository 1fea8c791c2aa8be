#include "runtime/render/field_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "runtime/render/colour_map.hpp"

namespace toile {
namespace {

struct Weighted {
  double value, weight;
};

/// Sorted by value; only finite ones with weight.
std::vector<Weighted> sorted(const std::vector<double>& values, const std::vector<double>& areas) {
  std::vector<Weighted> result;
  for (std::size_t i = 0; i < values.size() && i < areas.size(); ++i) {
    if (std::isfinite(values[i]) && areas[i] > 0) result.push_back({values[i], areas[i]});
  }
  std::stable_sort(result.begin(), result.end(), [](auto& a, auto& b) { return a.value < b.value; });
  return result;
}

double percentile(const std::vector<Weighted>& sorted, double fraction) {
  const double total =
      std::accumulate(sorted.begin(), sorted.end(), 0.0, [](double s, auto& w) { return s + w.weight; });
  double below = 0;
  for (const Weighted& w : sorted) {
    below += w.weight;
    if (below >= fraction * total) return w.value;
  }
  return sorted.back().value;
}

/// 1, 2 or 5 times a power of ten, the smallest that is not below.
double round_up(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= x * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

}  // namespace

FieldScale::FieldScale(const Field& field, const std::vector<double>& values, const std::vector<double>& areas)
    : name_(field.name), unit_(field.unit), to_unit_(field.to_unit), diverging_(field.diverging) {
  const std::vector<Weighted> all = sorted(values, areas);
  if (!all.empty()) {
    least_ = all.front().value;
    greatest_ = all.back().value;
    low_ = percentile(all, 0.01);
    high_ = percentile(all, 0.99);
    if (diverging_) {
      high_ = std::max(std::abs(low_), std::abs(high_));
      low_ = -high_;
    } else if (least_ >= 0) {
      const auto positive = std::find_if(all.begin(), all.end(), [](auto& w) { return w.value > 0; });
      low_ = 0;
      if (positive != all.end()) high_ = percentile({positive, all.end()}, 0.99);
    }
  }
  // A field that is the same everywhere still needs a scale; rounding noise about a constant is none.
  const double magnitude = std::max({std::abs(low_), std::abs(high_), 1e-12});
  if (!(high_ - low_ > 1e-9 * magnitude)) {
    high_ = low_ + 1 / to_unit_;
    if (diverging_) low_ = -high_;
  }
}

Rgb FieldScale::colour(double value) const {
  const double t = (value - low_) / (high_ - low_);
  return diverging_ ? diverging_colour(2 * t - 1) : sequential_colour(t);
}

std::vector<double> FieldScale::ticks() const {
  const double low = low_ * to_unit_;
  const double high = high_ * to_unit_;
  const double step = round_up((high - low) / 6);
  std::vector<double> result;
  const auto first = static_cast<long>(std::ceil(low / step - 1e-6));
  for (long i = first; i < first + 16 && static_cast<double>(i) * step <= high + 1e-6 * step; ++i) {
    result.push_back(static_cast<double>(i) * step);
  }
  return result;
}

std::string tick_label(double value, double step) {
  if (std::abs(value) < 1e-9 * step) return "0";
  const double largest = std::max(std::abs(value), step);
  if (largest >= 1e6 || step < 1e-4) return fmt::format("{:.1e}", value);
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace toile
