#include "compiler/solve/root.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace toile {
namespace {

constexpr int most_brent_steps = 200;

/// R. P. Brent, Algorithms for Minimization without Derivatives, 1973, chapter 4. `best` and `opposite` hold the root
/// between them, `best` with the smaller value; `before` is the last but one `best`.
class Brent {
 public:
  explicit Brent(Bracket bracket)
      : before_(bracket.low), best_(bracket.high), f_before_(bracket.at_low), f_best_(bracket.at_high) {
    take_before_as_opposite();
  }

  bool done() {
    if (std::abs(f_opposite_) < std::abs(f_best_)) {
      before_ = best_;
      f_before_ = f_best_;
      std::swap(best_, opposite_);
      std::swap(f_best_, f_opposite_);
    }
    tolerance_ = 2 * std::numeric_limits<double>::epsilon() * std::abs(best_) + 1e-300;
    return f_best_ == 0 || std::abs(opposite_ - best_) / 2 <= tolerance_;
  }

  double best() const { return best_; }

  /// Where to look next.
  double next() {
    choose_step();
    before_ = best_;
    f_before_ = f_best_;
    best_ += std::abs(step_) > tolerance_ ? step_ : std::copysign(tolerance_, opposite_ - best_);
    return best_;
  }

  void see(double value) {
    f_best_ = value;
    if ((f_best_ > 0) == (f_opposite_ > 0)) take_before_as_opposite();
  }

 private:
  void take_before_as_opposite() {
    opposite_ = before_;
    f_opposite_ = f_before_;
    step_ = last_step_ = best_ - before_;
  }

  void choose_step() {
    const double middle = (opposite_ - best_) / 2;
    if (std::abs(last_step_) < tolerance_ || std::abs(f_before_) <= std::abs(f_best_)) {
      step_ = last_step_ = middle;
      return;
    }
    const double s = f_best_ / f_before_;
    double p = 2 * middle * s;
    double q = 1 - s;
    if (before_ != opposite_) {  // three places: inverse quadratic interpolation
      const double u = f_before_ / f_opposite_;
      const double v = f_best_ / f_opposite_;
      p = s * (2 * middle * u * (u - v) - (best_ - before_) * (v - 1));
      q = (u - 1) * (v - 1) * (s - 1);
    }
    if (p > 0) q = -q;
    p = std::abs(p);
    const bool inside = 2 * p < 3 * middle * q - std::abs(tolerance_ * q) && 2 * p < std::abs(last_step_ * q);
    last_step_ = inside ? step_ : middle;
    step_ = inside ? p / q : middle;
  }

  double before_, best_, opposite_ = 0;
  double f_before_, f_best_, f_opposite_ = 0;
  double step_ = 0, last_step_ = 0, tolerance_ = 0;
};

}  // namespace

std::optional<double> root_within(const Function& function, Bracket bracket) {
  if (bracket.at_low == 0) return bracket.low;
  Brent search(bracket);
  for (int step = 0; step < most_brent_steps && !search.done(); ++step) {
    const std::optional<double> value = function(search.next());
    if (!value) return std::nullopt;
    search.see(*value);
  }
  return search.best();
}

}  // namespace toile
