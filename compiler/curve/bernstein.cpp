#include "compiler/curve/bernstein.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/solve/root.hpp"

namespace toile {
namespace {

constexpr double nothing = 1e-15;   // of the largest coefficient: zero but for rounding
constexpr double narrowest = 1e-8;  // in [0, 1]; two roots nearer than this are one that touches
constexpr double one_root = 1e-7;   // in [0, 1]

double binomial(std::size_t n, std::size_t k) {
  double value = 1;
  for (std::size_t i = 0; i < k; ++i) value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return value;
}

double evaluated(Bernstein b, double t) {
  for (std::size_t n = b.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) b[i] = (1 - t) * b[i] + t * b[i + 1];
  }
  return b[0];
}

/// The halves of a polynomial, each on [0, 1] again.
std::pair<Bernstein, Bernstein> halves(Bernstein b) {
  Bernstein left, right;
  while (!b.empty()) {
    left.push_back(b.front());
    right.push_back(b.back());
    for (std::size_t i = 0; i + 1 < b.size(); ++i) b[i] = (b[i] + b[i + 1]) / 2;
    b.pop_back();
  }
  std::reverse(right.begin(), right.end());
  return {left, right};
}

/// How often the coefficients change their sign: there are at most as many roots inside, and none fewer than by an even
/// number.
int sign_changes(const Bernstein& b) {
  int changes = 0;
  double last = 0;
  for (const double c : b) {
    if (c == 0) continue;
    if (last != 0 && (c > 0) != (last > 0)) ++changes;
    last = c;
  }
  return changes;
}

class RootSearch {
 public:
  explicit RootSearch(double scale) : zero_(nothing * scale) {}

  void look(const Bernstein& b, double begin, double end) {
    if (std::abs(b.front()) <= zero_) found_.push_back(begin);
    if (std::abs(b.back()) <= zero_) found_.push_back(end);
    const int changes = sign_changes(b);
    if (changes == 0) return;
    if (changes == 1 && b.front() * b.back() < 0) {
      const auto value = [&](double t) { return std::optional(evaluated(b, t)); };
      const double t = root_within(value, {0, 1, b.front(), b.back()}).value_or(0.5);
      found_.push_back(begin + t * (end - begin));
      return;
    }
    if (end - begin < narrowest) {
      found_.push_back((begin + end) / 2);
      return;
    }
    const auto [left, right] = halves(b);
    look(left, begin, (begin + end) / 2);
    look(right, (begin + end) / 2, end);
  }

  std::vector<double> take() {
    std::sort(found_.begin(), found_.end());
    const auto same = [](double a, double b) { return b - a < one_root; };
    found_.erase(std::unique(found_.begin(), found_.end(), same), found_.end());
    return std::move(found_);
  }

 private:
  double zero_;
  std::vector<double> found_;
};

}  // namespace

Bernstein operator*(const Bernstein& a, const Bernstein& b) {
  const std::size_t m = a.size() - 1, n = b.size() - 1;
  Bernstein product(m + n + 1, 0.0);
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      product[i + j] += binomial(m, i) * binomial(n, j) / binomial(m + n, i + j) * a[i] * b[j];
    }
  }
  return product;
}

Bernstein operator+(const Bernstein& a, const Bernstein& b) {
  Bernstein sum = a;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += b[i];
  return sum;
}

std::vector<double> roots(const Bernstein& polynomial) {
  double scale = 0;
  for (const double c : polynomial) scale = std::max(scale, std::abs(c));
  if (!(scale > 0) || !std::isfinite(scale)) return {};
  RootSearch search(scale);
  search.look(polynomial, 0, 1);
  return search.take();
}

}  // namespace toile
