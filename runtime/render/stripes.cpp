#include "runtime/render/stripes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace toile {

Stripes::Stripes(const std::vector<Stripe>& stripes) {
  Rgb sum;
  for (const Stripe& stripe : stripes) {
    if (!(stripe.width > 0) || !std::isfinite(stripe.width)) continue;
    colours_.push_back(linear(stripe.colour));
    integrals_.push_back(sum);
    repeat_ += stripe.width;
    ends_.push_back(repeat_);
    sum += stripe.width * colours_.back();
  }
  if (colours_.size() > 1) {
    whole_ = (1 / repeat_) * sum;
    return;
  }
  repeat_ = 0;
  if (!colours_.empty()) {
    whole_ = colours_.front();
  } else {
    whole_ = stripes.empty() ? grey(0.5) : linear(stripes.front().colour);
  }
}

Rgb Stripes::mean(double place, double width) const {
  if (repeat_ == 0 || width > 8 * repeat_) return whole_;
  const double turns = std::floor(place / repeat_);
  const double within = place - turns * repeat_;
  const double half = std::max(width, 1e-6 * repeat_) / 2;
  const Rgb mean = (1 / (2 * half)) * (integral(within + half) - integral(within - half));
  return {std::max(mean.r, 0.0), std::max(mean.g, 0.0), std::max(mean.b, 0.0)};
}

Rgb Stripes::integral(double place) const {
  const double turns = std::floor(place / repeat_);
  const double within = place - turns * repeat_;
  const auto found = std::upper_bound(ends_.begin(), ends_.end(), within);
  const auto i = static_cast<std::size_t>(std::min(found, ends_.end() - 1) - ends_.begin());
  const double begin = i == 0 ? 0 : ends_[i - 1];
  return (turns * repeat_) * whole_ + integrals_[i] + (within - begin) * colours_[i];
}

}  // namespace toile
