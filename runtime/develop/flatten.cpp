#include "runtime/develop/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/develop/coarse_start.hpp"
#include "runtime/develop/flattening.hpp"
#include "runtime/develop/flips.hpp"
#include "runtime/develop/plane_unknowns.hpp"
#include "runtime/mesh/index.hpp"
#include "runtime/solve/parallel.hpp"
#include "runtime/solve/sparse.hpp"

namespace toile {
namespace {

constexpr int most_halvings = 40;   // of a step that does not lower the energy
constexpr double first_match = 10;  // stiffness of a match over that of a strip of cloth as wide as the pattern
constexpr int most_aims = 12;       // at the lengths of sides that must match
constexpr double aimed = 0.25;      // of what they missed, that an aim has to leave less than; else they are stiffened
constexpr double fair_rest = 1e-3;  // relative residual at which they are aimed at anew
constexpr double near_rest = 1e-2;  // relative residual below which the true Hessian is tried first
constexpr double good_fall = 0.1;   // of the residual, after which the factor at hand serves once more

constexpr double least_share_of_grain = 0.7;  // of a piece's extent along the warp that its grain line spans

TargetTriangle speck() {
  constexpr double side = 1e-6;  // [m]
  return *target_triangle({Vec3{0, 0, 0}, Vec3{side, 0, 0}, Vec3{0, side, 0}});
}

/// What has no area in space has no place in the plane either: a speck stands for it.
TargetTriangle target_of(const FlatteningInput& input, std::size_t t) {
  const auto corner = [&](std::size_t i) { return input.target[index(input.triangles[t][i])]; };
  return target_triangle({corner(0), corner(1), corner(2)}).value_or(speck());
}

template <class Place>
double largest_mismatch(const FlatteningInput& input, const Place& place) {
  std::vector<double> sums;
  for (const LengthMatch& match : input.matches) {
    if (index(match.seam) >= sums.size()) sums.resize(index(match.seam) + 1, 0.0);
    const std::array<int, 4> p = points_of(match);
    sums[index(match.seam)] += mismatch(match, {place(p[0]), place(p[1]), place(p[2]), place(p[3])}).value;
  }
  double largest = 0;
  for (const double sum : sums) largest = std::max(largest, std::abs(sum));
  return largest;
}

class Flattening {
 public:
  Flattening(const FlatteningInput& input, const FabricLaw& law, const FlattenOptions& options)
      : input_(input),
        law_(law),
        options_(options),
        matrix_(well_ordered_plane_unknowns(input), plane_elements(input)) {
    for (std::size_t t = 0; t < input.triangles.size(); ++t) {
      targets_.push_back(target_of(input, t));
      triangle_places_.push_back(matrix_.places(plane_unknowns(input.triangles[t])));
    }
    for (const LengthMatch& match : input.matches) match_places_.push_back(matrix_.places(plane_unknowns(match)));
    q_ = Vector(2 * static_cast<Eigen::Index>(input.start.size()));
    const std::vector<Vec2> start = coarse_start(input, law);
    for (std::size_t i = 0; i < start.size(); ++i) {
      q_[2 * static_cast<Eigen::Index>(i)] = start[i].x;
      q_[2 * static_cast<Eigen::Index>(i) + 1] = start[i].y;
    }
    stiffness_ = 0.5 * (law.warp.initial_stiffness() + law.weft.initial_stiffness());
    double area = 0;
    for (const TargetTriangle& target : targets_) area += target.area;
    const double count = std::max<double>(1, static_cast<double>(targets_.size()));
    force_scale_ = stiffness_ * std::sqrt(4 / std::sqrt(3.0) * area / count);
    match_stiffness_ = first_match * stiffness_ * std::sqrt(area);
    aims_.assign(input.matches.size(), 0.0);
    hessians_.resize(targets_.size());
    cholesky_.join_more_columns();
    cholesky_.analyse_in_order(matrix_);
  }

  Flattened run(const Job& job) {
    minimise(job);
    return result();
  }

 private:
  static Vec2 at(const Vector& q, int point) { return {q[2 * point], q[2 * point + 1]}; }
  PlaneCorners corners(const Vector& q, std::size_t t) const {
    const std::array<int, 3>& triangle = input_.triangles[t];
    return {at(q, triangle[0]), at(q, triangle[1]), at(q, triangle[2])};
  }
  Mismatch mismatch_of(std::size_t match, const Vector& q) const {
    const std::array<int, 4> p = points_of(input_.matches[match]);
    Mismatch found = mismatch(input_.matches[match], {at(q, p[0]), at(q, p[1]), at(q, p[2]), at(q, p[3])});
    found.value -= aims_[match];
    return found;
  }
  double largest_mismatch_now() const {
    return largest_mismatch(input_, [&](int point) { return at(q_, point); });
  }

  double energy(const Vector& q, Vector& gradient, std::vector<FlatTriangle>& flat) const;
  bool assemble(Curvature curvature, double lift);
  void add_matches(Curvature curvature);
  bool factorise(double residual);
  double longest_step(const Vector& step) const;
  double residual_force(const Vector& gradient) const;
  Vector newton_step(const Vector& gradient) const;
  bool aim_anew();
  void minimise(const Job& job);
  std::vector<Vec2> places() const {
    std::vector<Vec2> all;
    for (int i = 0; i < static_cast<int>(input_.start.size()); ++i) all.push_back(at(q_, i));
    return all;
  }
  Flattened result() const;

  const FlatteningInput& input_;
  const FabricLaw& law_;
  const FlattenOptions& options_;
  SparseMatrix matrix_;
  Cholesky cholesky_;
  std::vector<TargetTriangle> targets_;
  std::vector<std::vector<std::int32_t>> triangle_places_, match_places_;
  Vector q_;
  std::vector<FlatTriangle> flat_;  // as they lie at q_
  std::vector<Matrix6> hessians_;
  double stiffness_ = 0, force_scale_ = 0, match_stiffness_ = 0;
  std::vector<double>
      aims_;  // [m] of each match: how much its spring wants it longer, so that with the load it is right
  double missed_ = std::numeric_limits<double>::infinity();  // [m] the largest mismatch when it was aimed last
  int aims_taken_ = 0;
  double residual_ = 0;  // [N]
  int iterations_ = 0;
  bool converged_ = false, cancelled_ = false;
};

double Flattening::energy(const Vector& q, Vector& gradient, std::vector<FlatTriangle>& flat) const {
  flat.resize(input_.triangles.size());
  parallel_for(flat.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) flat[t] = FlatTriangle(law_, targets_[t], corners(q, t));
  });
  double sum = 0;
  gradient.setZero(q.size());
  for (std::size_t t = 0; t < flat.size(); ++t) {
    sum += flat[t].whole_energy();
    const Vector6 slope = flat[t].gradient();
    for (int i = 0; i < 3; ++i) {
      gradient.segment<2>(2 * input_.triangles[t][static_cast<std::size_t>(i)]) += slope.segment<2>(2 * i);
    }
  }
  for (std::size_t i = 0; i < input_.matches.size(); ++i) {
    const LengthMatch& match = input_.matches[i];
    const Mismatch m = mismatch_of(i, q);
    const double k = match_stiffness_ / match.length;
    sum += 0.5 * k * m.value * m.value;
    const std::array<int, 4> points = points_of(match);
    for (int end = 0; end < 4; ++end) {
      gradient.segment<2>(2 * points[index(end)]) += k * m.value * m.gradient.segment<2>(2 * end);
    }
  }
  for (std::size_t i = 0; i < matrix_.reduced().size(); ++i) {
    if (matrix_.reduced()[i] < 0) gradient[static_cast<Eigen::Index>(i)] = 0;
  }
  return sum;
}

void Flattening::add_matches(Curvature curvature) {
  for (std::size_t m = 0; m < input_.matches.size(); ++m) {
    const LengthMatch& match = input_.matches[m];
    const Mismatch found = mismatch_of(m, q_);
    Matrix8 hessian = found.gradient * found.gradient.transpose();
    if (curvature == Curvature::Full) hessian += found.value * found.hessian;
    hessian *= match_stiffness_ / match.length;
    add_match(match, hessian, match_places_[m], matrix_);
  }
}

bool Flattening::assemble(Curvature curvature, double lift) {
  parallel_for(hessians_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) hessians_[t] = flat_[t].hessian(curvature);
  });
  matrix_.set_zero();
  for (std::size_t t = 0; t < hessians_.size(); ++t) {
    std::size_t k = 0;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j <= i; ++j, ++k) {
        const std::int32_t place = triangle_places_[t][k];
        if (place >= 0) matrix_.add_at(place, hessians_[t](i, j));
      }
    }
  }
  add_matches(curvature);
  const std::vector<double> ones(matrix_.reduced().size(), 1.0);
  matrix_.add_diagonal(ones, lift * stiffness_);
  return cholesky_.factorise(matrix_);
}

bool Flattening::factorise(double residual) {
  if (residual < near_rest && assemble(Curvature::Full, 0)) return true;
  for (double lift = 1e-12; lift < 1e3; lift *= 100) {
    if (assemble(Curvature::PositiveDefinite, lift)) return true;
  }
  return false;
}

double Flattening::longest_step(const Vector& step) const {
  double longest = 1;
  for (std::size_t t = 0; t < input_.triangles.size(); ++t) {
    longest = std::min(longest, step_before_flip(corners(q_, t), corners(step, t)));
  }
  return longest;
}

double Flattening::residual_force(const Vector& gradient) const {
  double largest = 0;
  for (Eigen::Index i = 0; i < gradient.size(); i += 2) {
    largest = std::max(largest, gradient.segment<2>(i).norm());
  }
  return largest;
}

Vector Flattening::newton_step(const Vector& gradient) const {
  return cholesky_.solve_free(matrix_, -gradient);
}

/// Springs hold sides that must match as long as each other but for what they give under load; that is added to what
/// they hold them to (the method of multipliers). False once they match, or do not.
bool Flattening::aim_anew() {
  const double now = largest_mismatch_now();
  if (now <= options_.length_tolerance || aims_taken_ == most_aims) return false;
  ++aims_taken_;
  for (std::size_t m = 0; m < aims_.size(); ++m) aims_[m] = -mismatch_of(m, q_).value;
  if (now > aimed * missed_) {
    match_stiffness_ *= 10;
    for (double& aim : aims_) aim /= 10;
  }
  missed_ = now;
  return true;
}

void Flattening::minimise(const Job& job) {
  const double goal = options_.tolerance * force_scale_;
  Vector gradient, trial_gradient;
  std::vector<FlatTriangle> trial_flat;
  double now = energy(q_, gradient, flat_);
  const double first = residual_force(gradient);
  bool factored = false;
  for (int round = 0; round < options_.max_iterations; ++round, ++iterations_) {
    double before = std::exchange(residual_, residual_force(gradient));
    if (residual_ <= std::max(goal, fair_rest * force_scale_) && aim_anew()) {
      now = energy(q_, gradient, flat_);
      residual_ = residual_force(gradient);
      before = std::numeric_limits<double>::infinity();  // what gives way is the same
    }
    converged_ = residual_ <= goal;
    cancelled_ = job.is_cancelled();
    if (converged_ || cancelled_) return;
    if (job.report) {
      const double way = std::log(std::max(first / goal, 1 + 1e-9));
      job.report({"developing", std::clamp(1 - std::log(std::max(residual_ / goal, 1.0)) / way, 0.0, 1.0), iterations_,
                  residual_ / force_scale_});
    }
    factored = factored && residual_ < good_fall * before;
    const bool fresh = !factored;
    if (fresh && !factorise(residual_ / force_scale_)) return;
    factored = true;
    const Vector step = newton_step(gradient);
    const double slope = gradient.dot(step);
    if (!(slope < 0)) return;
    const double noise = 1e-14 * std::abs(now);
    double fraction = longest_step(step);
    bool lowered = false;
    for (int halving = 0; halving < most_halvings && !lowered; ++halving, fraction *= 0.5) {
      const Vector trial = q_ + fraction * step;
      const double then = energy(trial, trial_gradient, trial_flat);  // nearly always it goes on from there
      if (!std::isfinite(then) || then > now + 1e-4 * fraction * slope + noise) continue;
      lowered = true;
      q_ = trial;
      now = then;
      gradient.swap(trial_gradient);
      flat_.swap(trial_flat);
    }
    if (!lowered && fresh) return;
    if (!lowered) factored = false;
  }
}

Flattened Flattening::result() const {
  Flattened flat = measured(input_, law_, places());
  flat.converged = converged_ && flat.mismatch <= options_.length_tolerance;
  flat.cancelled = cancelled_;
  flat.iterations = iterations_;
  flat.factorisations = cholesky_.factorisations();
  flat.residual_N = residual_;
  flat.residual_relative = residual_ / force_scale_;
  return flat;
}

}  // namespace

FlatteningInput::GrainLine grain_line(const std::vector<Vec2>& start, const std::vector<int>& outline) {
  double low = 1e300, high = -1e300, middle = 0;
  for (const int point : outline) {
    const Vec2 place = start[index(point)];
    low = std::min(low, place.x);
    high = std::max(high, place.x);
    middle += place.y / static_cast<double>(outline.size());
  }
  FlatteningInput::GrainLine best{outline.front(), outline.back()};
  double least = 1e300;
  for (const int a : outline) {
    for (const int b : outline) {
      const Vec2 way = start[index(b)] - start[index(a)];
      if (way.x < least_share_of_grain * (high - low)) continue;
      const double aside = 0.5 * (start[index(a)].y + start[index(b)].y) - middle;
      const double crooked = std::abs(way.y) / way.x + 1e-3 * std::abs(aside) / (high - low);
      if (crooked < least) {
        least = crooked;
        best = {a, b};
      }
    }
  }
  return best;
}

Flattened measured(const FlatteningInput& input, const FabricLaw& law, std::vector<Vec2> uv) {
  Flattened flat;
  for (std::size_t t = 0; t < input.triangles.size(); ++t) {
    const std::array<int, 3>& triangle = input.triangles[t];
    const PlaneCorners corners{uv[index(triangle[0])], uv[index(triangle[1])], uv[index(triangle[2])]};
    const TargetTriangle target = target_of(input, t);
    const FlatTriangle flattened(law, target, corners);
    const MembraneEnergy parts = flattened.energy();
    flat.energy.warp += parts.warp;
    flat.energy.weft += parts.weft;
    flat.energy.shear += parts.shear;
    flat.strains.push_back(flattened.strain());
    flat.area += 0.5 * turn(corners);
    flat.target_area += target.area;
    if (!(turn(corners) > 0)) ++flat.flipped;
  }
  flat.mismatch = largest_mismatch(input, [&](int point) { return uv[index(point)]; });
  flat.uv = std::move(uv);
  return flat;
}

Flattened flatten(const FlatteningInput& input, const FabricLaw& law, const FlattenOptions& options, const Job& job) {
  return Flattening(input, law, options).run(job);
}

}  // namespace toile
