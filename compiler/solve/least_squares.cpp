#include "compiler/solve/least_squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace toile {
namespace {

using Vector = std::vector<double>;

constexpr int most_starts = 9;
constexpr int most_descent_steps = 60;
constexpr double difference = 1e-5;  // of a range, for slopes

double square_sum(const Vector& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return sum;
}

double largest(const Vector& v) {
  double most = 0;
  for (const double x : v) most = std::max(most, std::abs(x));
  return most;
}

/// Radical inverse: the k-th place of an evenly spread sequence in (0, 1).
double spread(int k, int base) {
  double place = 0, weight = 1;
  for (; k > 0; k /= base) place += (weight /= base) * (k % base);
  return place;
}

/// Solves a symmetric positive definite system in place by Cholesky's factors; false when it is not definite.
bool solve_symmetric(std::vector<Vector> a, Vector& b) {
  const std::size_t n = b.size();
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) {
      for (std::size_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
      if (i == j && !(a[j][j] > 0)) return false;
      a[i][j] = i == j ? std::sqrt(a[j][j]) : a[i][j] / a[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
  return true;
}

/// One descent. Unknowns are counted in parts of their ranges, from 0 to 1.
class Descent {
 public:
  Descent(const Residuals& residuals, const std::vector<Range>& ranges) : residuals_(residuals), ranges_(ranges) {}

  std::optional<Fit> from(Vector place, double tolerance) {
    place_ = std::move(place);
    const auto first = value(place_);
    if (!first) return std::nullopt;
    found_ = *first;
    double damping = 1e-3;
    for (int step = 0; step < most_descent_steps && largest(found_) > tolerance * 1e-3; ++step) {
      if (!find_slopes()) break;
      bool better = false;
      for (int attempt = 0; attempt < 12 && !better; ++attempt) {
        better = try_step(damping);
        damping = better ? std::max(damping / 10, 1e-14) : damping * 5;
      }
      if (!better) break;
    }
    return Fit{scaled(place_), found_, square_sum(found_)};
  }

 private:
  Vector scaled(const Vector& place) const {
    Vector values;
    for (std::size_t i = 0; i < place.size(); ++i) {
      values.push_back(ranges_[i].low + place[i] * (ranges_[i].high - ranges_[i].low));
    }
    return values;
  }

  std::optional<Vector> value(const Vector& place) const { return residuals_(scaled(place)); }

  /// Central differences where both sides lie in the range, one-sided at its ends.
  bool find_slopes() {
    slopes_.assign(place_.size(), {});
    for (std::size_t i = 0; i < place_.size(); ++i) {
      Vector before = place_, after = place_;
      before[i] = std::max(0.0, place_[i] - difference);
      after[i] = std::min(1.0, place_[i] + difference);
      const auto low = value(before);
      const auto high = value(after);
      if (!low || !high) return false;
      for (std::size_t k = 0; k < low->size(); ++k) {
        slopes_[i].push_back(((*high)[k] - (*low)[k]) / (after[i] - before[i]));
      }
    }
    return true;
  }

  double along(std::size_t i, const Vector& v) const {
    double sum = 0;
    for (std::size_t k = 0; k < v.size(); ++k) sum += slopes_[i][k] * v[k];
    return sum;
  }

  /// Whether a step of that damping brings the residuals down; then it is taken.
  bool try_step(double damping) {
    const std::size_t n = place_.size();
    std::vector<std::size_t> free;  // unknowns that are not held by the end of their range
    for (std::size_t i = 0; i < n; ++i) {
      const double uphill = along(i, found_);
      if (!((place_[i] <= 0 && uphill > 0) || (place_[i] >= 1 && uphill < 0))) free.push_back(i);
    }
    std::vector<Vector> normal(free.size(), Vector(free.size()));
    Vector step(free.size());
    for (std::size_t i = 0; i < free.size(); ++i) {
      for (std::size_t j = 0; j < free.size(); ++j) normal[i][j] = along(free[i], slopes_[free[j]]);
      normal[i][i] += damping * std::max(normal[i][i], 1e-12);
      step[i] = -along(free[i], found_);
    }
    if (free.empty() || !solve_symmetric(normal, step)) return false;
    Vector next = place_;
    for (std::size_t i = 0; i < free.size(); ++i) next[free[i]] = std::clamp(next[free[i]] + step[i], 0.0, 1.0);
    const auto there = value(next);
    if (!there || !(square_sum(*there) < square_sum(found_))) return false;
    place_ = next;
    found_ = *there;
    return true;
  }

  const Residuals& residuals_;
  const std::vector<Range>& ranges_;
  Vector place_, found_;
  std::vector<Vector> slopes_;  // of all residuals, by unknown
};

}  // namespace

std::optional<Fit> least_squares(const Residuals& residuals, const std::vector<Range>& ranges, double tolerance) {
  constexpr std::array primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  std::optional<Fit> best;
  for (int start = 0; start < most_starts; ++start) {
    Vector place;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      place.push_back(start == 0 ? 0.5 : spread(start, primes[i % primes.size()]));
    }
    const auto fit = Descent(residuals, ranges).from(place, tolerance);
    if (fit && (!best || fit->cost < best->cost)) best = fit;
    if (best && largest(best->residuals) <= tolerance) break;
  }
  return best;
}

}  // namespace toile
