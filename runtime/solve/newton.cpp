#include "runtime/solve/newton.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace toile {
namespace {

constexpr double highest_lift = 1e2, lowest_lift = 1e-3;  // [1/s2]
constexpr double highest_lift_near_rest = 1e4;            // a saddle is left along its own way down
constexpr double near_rest = 0.5;                         // relative residual
constexpr int most_halvings = 13;                         // of a step that does not lower the energy
constexpr int longest_pause = 8;                          // iterations
// A step may raise the energy, but not above the highest of so many (Grippo, Lampariello and Lucidi, 1986): what a long
// step along a fold stretches, the next one takes back.
constexpr std::size_t remembered = 5;
// Where the highest of the latest falls by less than this share of their spread, steps go to and fro, and for a while
// each has to lower the energy.
constexpr double least_fall = 0.1;
constexpr int careful_steps = 10;
// Layers that all but touch stop every long step, and so never come apart: after so many steps that contact cut to less
// than this share, shorter ones are made, in which the layers near each other have their way.
constexpr double hardly_free = 0.05;
constexpr int most_stops = 5;
constexpr double highest_rate_of_stops = 1e8;  // [1/s2]

/// One run of Newton's method.
class Newton {
 public:
  Newton(const NewtonProblem& problem, const NewtonOptions& options, const Job& job, Vector& q)
      : problem_(problem), options_(options), job_(job), q_(q), rate_(options.rate) {}

  NewtonOutcome run();

 private:
  double evaluate(const Vector& q, Vector* gradient) const;
  bool factorise();
  bool factorise(Curvature curvature, double rate);
  double longest(const Vector& step) const;
  Vector direction() const;
  /// The accepted fraction of the step, 0 when none does.
  double search(const Vector& step);
  double free_fraction(const Vector& step) const;
  double highest_of_latest() const;
  void remember();
  /// Doubles an accepted step while the energy goes on falling.
  void lengthen(const Vector& step, double energy, double slope);
  void settle();
  void adapt(double fraction);

  const NewtonProblem& problem_;
  const NewtonOptions& options_;
  const Job& job_;
  Vector& q_;
  Vector gradient_;
  double energy_ = 0;
  std::deque<double> energies_;  // the latest ones, twice as many as may be climbed to
  int careful_ = 0;              // steps that have to lower the energy
  int stops_ = 0;                // steps, one after the other, that contact all but forbade
  double rate_ = 0;
  double lift_ = 0;                 // [1/s2] what the true Hessian took lately, beyond the rate, to be definite
  int pause_ = 0, next_pause_ = 1;  // iterations without trying it
  bool stiffened_ = false;          // the latest factor is of the positive-definite part: its steps are short
};

double Newton::evaluate(const Vector& q, Vector* gradient) const {
  if (gradient != nullptr) gradient->setZero(q.size());
  double energy = 0;
  for (const Form* form : problem_.forms) energy += form->energy(q, gradient);
  if (gradient != nullptr) {
    const std::vector<int>& reduced = problem_.matrix->reduced();
    for (std::size_t i = 0; i < reduced.size(); ++i) {
      if (reduced[i] < 0) (*gradient)[static_cast<Eigen::Index>(i)] = 0;
    }
  }
  return energy;
}

bool Newton::factorise(Curvature curvature, double rate) {
  stiffened_ = curvature == Curvature::PositiveDefinite;
  problem_.matrix->set_zero();
  for (const Form* form : problem_.forms) form->add_hessian(q_, curvature, *problem_.matrix);
  problem_.matrix->add_diagonal(problem_.inertia, rate);
  return problem_.cholesky->factorise(*problem_.matrix);
}

bool Newton::factorise() {
  if (problem_.fit) problem_.fit(q_);
  // The true Hessian, lifted just so far that it is definite, goes along the soft folds of the cloth; where that would
  // take too much lifting, its positive-definite part makes the better step, and the true one is left in peace for a
  // while.
  if (pause_ > 0) {
    --pause_;
    return factorise(Curvature::PositiveDefinite, rate_);
  }
  const double highest = problem_.residual(gradient_, q_) < near_rest ? highest_lift_near_rest : highest_lift;
  for (int trial = 0; trial < 3 && std::max(rate_, lift_) < highest; ++trial) {
    if (factorise(Curvature::Full, std::max(rate_, lift_))) {
      lift_ = lift_ < lowest_lift ? 0 : lift_ / 3;
      next_pause_ = 1;
      return true;
    }
    lift_ = std::max({10 * lift_, 10 * rate_, 1.0});
  }
  lift_ = std::min(lift_, highest / 2);
  pause_ = next_pause_;
  next_pause_ = std::min(2 * next_pause_, longest_pause);
  return factorise(Curvature::PositiveDefinite, rate_);
}

double Newton::longest(const Vector& step) const {
  double longest = 0;
  for (Eigen::Index i = 0; i < problem_.coordinates; i += 3) longest = std::max(longest, step.segment<3>(i).norm());
  return longest;
}

Vector Newton::direction() const {
  Vector step = problem_.cholesky->solve_free(*problem_.matrix, -gradient_);
  const double length = longest(step);
  if (length > options_.longest_step) step *= options_.longest_step / length;
  return step;
}

double Newton::free_fraction(const Vector& step) const {
  double free = 1;
  for (const Form* form : problem_.forms) free = std::min(free, form->free_fraction(q_, step));
  return free;
}

double Newton::search(const Vector& step) {
  const double slope = gradient_.dot(step);
  if (!(slope < 0)) return 0;
  const double highest = (careful_ > 0 ? energy_ : highest_of_latest()) + 1e-13 * std::abs(energy_);
  const double free = free_fraction(step);
  stops_ = free < hardly_free ? stops_ + 1 : 0;
  for (int halvings = 0; halvings <= most_halvings; ++halvings) {
    const double fraction = std::ldexp(free, -halvings);
    const Vector trial = q_ + fraction * step;
    const double energy = evaluate(trial, nullptr);
    if (std::isfinite(energy) && energy <= highest + 1e-4 * fraction * slope) {
      const Vector from = q_;
      q_ = trial;
      if (fraction == 1 && stiffened_ && energy < energy_) lengthen(step, energy, slope);
      for (Form* form : problem_.forms) form->foresee(from, q_ - from);
      // Being stopped by contact is no reason to go on more carefully, nor a reason to be bolder.
      return free == 1 ? fraction : 0.5 * fraction / free;
    }
  }
  return 0;
}

void Newton::lengthen(const Vector& step, double energy, double slope) {
  const Vector from = q_ - step;
  for (double factor = 2; factor * longest(step) <= options_.longest_step; factor *= 2) {
    const Vector further = factor / 2 * step;
    if (free_fraction(further) < 1) return;
    const Vector trial = from + factor * step;
    const double farther = evaluate(trial, nullptr);
    if (!(farther < energy + 1e-4 * slope)) return;
    energy = farther;
    q_ = trial;
  }
}

void Newton::settle() {
  for (Form* form : problem_.forms) form->accept(q_);
  energy_ = evaluate(q_, &gradient_);
  remember();
}

double Newton::highest_of_latest() const {
  const auto latest = static_cast<std::ptrdiff_t>(std::min(energies_.size(), remembered));
  return *std::max_element(energies_.end() - latest, energies_.end());
}

void Newton::remember() {
  energies_.push_back(energy_);
  careful_ = std::max(careful_ - 1, 0);
  if (energies_.size() <= 2 * remembered) return;
  energies_.pop_front();
  const auto middle = energies_.begin() + remembered;
  const double before = *std::max_element(energies_.begin(), middle), now = highest_of_latest();
  if (careful_ == 0 && before - now < least_fall * (now - *std::min_element(middle, energies_.end()))) {
    careful_ = careful_steps;
  }
}

void Newton::adapt(double fraction) {
  if (fraction == 1) rate_ *= 0.4;
  if (fraction < 0.3) rate_ *= fraction == 0 ? 10 : 3;
  if (stops_ >= most_stops && rate_ < highest_rate_of_stops) rate_ *= 10;
  rate_ = std::max(rate_, 1e-9 * options_.rate);
}

NewtonOutcome Newton::run() {
  NewtonOutcome outcome;
  settle();
  const double first = problem_.residual(gradient_, q_);
  for (;; ++outcome.iterations) {
    outcome.residual = problem_.residual(gradient_, q_);
    outcome.converged = outcome.residual <= options_.tolerance;
    outcome.cancelled = job_.is_cancelled();
    if (outcome.converged || outcome.cancelled || outcome.iterations >= options_.max_iterations) break;
    if (problem_.is_lost && problem_.is_lost(q_)) break;
    if (job_.report) {
      const double way = std::log(std::max(first / options_.tolerance, 1 + 1e-9));
      const double done = std::log(std::max(outcome.residual / options_.tolerance, 1.0));
      job_.report({"draping", std::clamp(1 - done / way, 0.0, 1.0), outcome.iterations, outcome.residual});
    }
    if (!factorise()) {
      rate_ *= 10;
      if (rate_ > 1e12 * options_.rate) break;
      continue;
    }
    const double fraction = search(direction());
    if (fraction > 0) settle();
    adapt(fraction);
    if (rate_ > 1e12 * options_.rate) break;
  }
  outcome.rate = rate_;
  return outcome;
}

}  // namespace

NewtonOutcome newton(const NewtonProblem& problem, const NewtonOptions& options, const Job& job, Vector& q) {
  return Newton(problem, options, job, q).run();
}

}  // namespace toile
