#include "runtime/drape/drape.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <variant>

#include "runtime/contact/body_contact.hpp"
#include "runtime/contact/self_contact.hpp"
#include "runtime/contact/self_intersections.hpp"
#include "runtime/contact/untangle.hpp"
#include "runtime/drape/describe.hpp"
#include "runtime/drape/rest_state.hpp"
#include "runtime/energy/elastic.hpp"
#include "runtime/energy/gravity.hpp"
#include "runtime/mesh/index.hpp"
#include "runtime/solve/newton.hpp"
#include "runtime/solve/okabe.hpp"

namespace toile {
namespace {

constexpr double untangling_rate = 1e4;   // [1/s2] how far a push against a crossing spreads
constexpr double untangling_step = 0.05;  // of the mean edge
constexpr double free_accuracy = 0.05;    // of a cloth that may still pass through itself
constexpr int free_iterations = 120;
constexpr int free_rounds = 5;
constexpr double lowest_rest_lift = 1e-2, highest_rest_lift = 1e8;  // [1/s2]
constexpr double out_of_touch = 0.02;                               // [m] below a body
constexpr double usual_extent = 2;  // [m] of what the solver's longest step is meant for
// Of a vertex's weight: what a force is measured by where there is neither gravity nor tension, as in a flat cloth.
constexpr double weightless_scale = 1e-6;
constexpr double carried_rate = 30;  // [1/s2] a form that was carried over needs little holding back

std::vector<int> reduced_unknowns(const ClothUnknowns& unknowns, const std::vector<int>& held) {
  std::vector<int> reduced(static_cast<std::size_t>(unknowns.count()), 0);
  for (const int vertex : held) {
    for (int k = 0; k < 3; ++k) reduced[index(3 * vertex + k)] = -1;
  }
  int next = 0;
  for (int& r : reduced) {
    if (r == 0) r = next++;
  }
  return reduced;
}

std::vector<FabricLaw> laws_of(const std::vector<FabricSheet>& fabrics, double membrane) {
  std::vector<FabricLaw> laws;
  laws.reserve(fabrics.size());
  for (const FabricSheet& fabric : fabrics) laws.push_back(softened(make_law(fabric), membrane));
  return laws;
}

/// One value of each fabric.
std::vector<double> each(const std::vector<FabricLaw>& laws, double FabricLaw::*value) {
  std::vector<double> values;
  values.reserve(laws.size());
  for (const FabricLaw& law : laws) values.push_back(law.*value);
  return values;
}

std::vector<double> vertex_masses(const Cloth& cloth, const std::vector<FabricLaw>& laws) {
  std::vector<double> masses(cloth.area_of_vertex.size(), 0.0);
  for (const ClothTriangle& triangle : cloth.triangles) {
    const double area = 0.5 * cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0]);
    for (const int v : triangle.vertices) masses[index(v)] += laws[index(triangle.fabric)].weight * area / 3;
  }
  return masses;
}

/// A smooth, fixed disturbance of low wavenumber, so that folds are not locked to a symmetry of the start.
void disturb(Vector& q, const std::vector<int>& reduced, int vertices, double amplitude) {
  for (int v = 0; v < vertices; ++v) {
    if (reduced[index(3 * v)] < 0) continue;
    const Vector3 x = q.segment<3>(3 * v);
    const Vector3 wave(std::sin(31 * x.y() + 17 * x.z() + 0.7), std::sin(29 * x.x() - 19 * x.z() + 1.9),
                       std::sin(23 * x.x() + 27 * x.y() + 0.3));
    q.segment<3>(3 * v) += amplitude * wave;
  }
}

/// Everything of one drape that the solvers and the result share.
class Draping {
 public:
  Draping(const Cloth& cloth, const std::vector<FabricSheet>& fabrics, const Body* body, const Placed& start,
          const DrapeOptions& options)
      : cloth_(cloth),
        laws_(laws_of(fabrics, options.membrane)),
        options_(options),
        elastic_(cloth, laws_),
        gravity_(vertex_masses(cloth, laws_)),
        layers_(cloth, layer_gaps(), std::ranges::max(each(laws_, &FabricLaw::pressure))),
        matrix_(reduced_unknowns(elastic_.unknowns(), start.held), elastic_.couplings()) {
    if (options.friction) layers_.set_friction(each(laws_, &FabricLaw::friction));
    if (body != nullptr) {
      contact_ = std::make_unique<BodyContact>(cloth, *body, half_thicknesses(), frictions(*body));
      stiffness_ = body->spec().softness;
      for (const Vec3& p : body->surface().points) lowest_of_body_ = std::min(lowest_of_body_, p.z);
      is_floor_ = std::holds_alternative<PlaneSpec>(body->spec().shape) || body->surface().points.empty();
    }
    holds_ = !start.held.empty();
    q_ = Vector::Zero(elastic_.unknowns().count());
    for (int v = 0; v < cloth.vertex_count; ++v) {
      q_.segment<3>(3 * v) = to_eigen(start.positions[static_cast<std::size_t>(v)]);
    }
    const auto coordinates = q_.head(3 * cloth.vertex_count).reshaped(3, cloth.vertex_count);
    extent_ = (coordinates.rowwise().maxCoeff() - coordinates.rowwise().minCoeff()).norm();
    if (!options.carried_over) disturb(q_, matrix_.reduced(), cloth.vertex_count, 0.02 * mean_edge());
    weight_per_vertex_ = (weighs() ? 1 : weightless_scale) * gravity_.weight() / std::max(cloth.vertex_count, 1);
  }

  Drape run(const Job& job);

 private:
  bool weighs() const { return options_.gravity; }
  /// The paper's method moves every variable by itself and knows nothing of crossings.
  bool layered() const { return options_.solver == DrapeOptions::Solver::Newton; }
  /// At which the layers of each fabric touch.
  std::vector<double> layer_gaps() const {
    std::vector<double> gaps = each(laws_, &FabricLaw::thickness);
    for (double& gap : gaps) gap = std::max(gap, options_.least_gap);
    return gaps;
  }
  std::vector<double> half_thicknesses() const {
    std::vector<double> halves = each(laws_, &FabricLaw::thickness);
    for (double& half : halves) half /= 2;
    return halves;
  }
  std::vector<double> frictions(const Body& body) const {
    if (!options_.friction) return std::vector<double>(laws_.size(), 0.0);
    if (body.spec().friction) return std::vector<double>(laws_.size(), *body.spec().friction);
    return each(laws_, &FabricLaw::friction);
  }
  double mean_edge() const {
    return std::sqrt(4 / std::sqrt(3.0) * cloth_.area /
                     static_cast<double>(std::max<std::size_t>(cloth_.triangles.size(), 1)));
  }
  std::vector<Form*> forms();
  std::vector<double> inertia() const;
  double scale(const Vector& q) const { return std::max(weight_per_vertex_, elastic_.mean_internal_force(q)); }
  /// The weight that nothing carries yet [N].
  double uncarried(const Vector& gradient) const;
  double relative_residual(const Vector& gradient, const Vector& q) const;
  /// Out of the crossings of the start, which contact would keep.
  void untangle(const Job& job);
  /// The pairs of triangles that still cross.
  int pull_apart(const Job& job);
  /// Towards rest with layers that pass through each other: about limbs and at rest, cloth lies as it is sewn.
  void settle_freely(const Job& job);
  NewtonProblem problem(std::vector<Form*> forms);
  /// All of it is below the body, and nothing holds it.
  bool falls_for_ever(const Vector& q) const;
  /// Gives the matrix places for the layers that touch at q.
  void fit(const Vector& q);
  /// Puts the matrix into an order that keeps its factor sparse.
  void analyse();
  /// Hands the state of rest to whoever asked for it.
  void show_rest();
  NewtonOutcome solve_newton(const Job& job);
  NewtonOutcome solve_okabe(const Job& job);

  const Cloth& cloth_;
  std::vector<FabricLaw> laws_;  // of each fabric
  const DrapeOptions& options_;
  ElasticForm elastic_;
  GravityForm gravity_;
  std::unique_ptr<BodyContact> contact_;
  SelfContact layers_;
  SparseMatrix matrix_;
  Cholesky cholesky_;
  double stiffness_ = 0;
  double lowest_of_body_ = 1e300;  // [m]
  bool holds_ = false;             // somewhere
  bool is_floor_ = false;          // the body: nothing falls past it
  double weight_per_vertex_ = 0;
  double extent_ = 0;  // [m] of the cloth's start
  Vector q_;
};

std::vector<Form*> Draping::forms() {
  std::vector<Form*> forms{&elastic_};
  if (weighs()) forms.push_back(&gravity_);
  if (contact_) forms.push_back(contact_.get());
  if (layered()) forms.push_back(&layers_);
  return forms;
}

std::vector<double> Draping::inertia() const {
  const std::vector<double> masses = vertex_masses(cloth_, laws_);
  std::vector<double> inertia;
  for (const double mass : masses) inertia.insert(inertia.end(), 3, mass);
  // A rotation is as heavy as the cloth about its edge.
  const double arm = mean_edge();
  const double mean_mass = std::accumulate(masses.begin(), masses.end(), 0.0) / std::max(cloth_.edge_count, 1);
  inertia.resize(static_cast<std::size_t>(elastic_.unknowns().count()), 0.1 * mean_mass * arm * arm);
  return inertia;
}

double Draping::relative_residual(const Vector& gradient, const Vector& q) const {
  const LargestResidual largest = largest_residual(gradient, elastic_.unknowns());
  const double scale = std::max(this->scale(q), 1e-300);
  const double residual = std::max(largest.force, largest.moment / mean_edge()) / scale;
  return weighs() ? std::max(residual, std::abs(uncarried(gradient)) / gravity_.weight()) : residual;
}

void Draping::untangle(const Job& job) {
  int fewest = pull_apart(job);
  Vector best = q_;
  for (int round = 0; round < free_rounds && fewest > 0 && !job.is_cancelled(); ++round) {
    settle_freely(job);
    const int pairs = pull_apart(job);
    if (pairs >= fewest && round > 0) break;
    if (pairs > fewest) continue;
    fewest = pairs;
    best = q_;
  }
  q_ = best;
  if (fewest > 0) layers_.leave_out(about_crossings(cloth_, q_));
}

int Draping::pull_apart(const Job& job) {
  const auto readily = [this](const Vector& force) {
    matrix_.set_zero();
    elastic_.add_hessian(q_, Curvature::PositiveDefinite, matrix_);
    matrix_.add_diagonal(inertia(), untangling_rate);
    return cholesky_.factorise(matrix_) ? cholesky_.solve_free(matrix_, force) : force;
  };
  return toile::untangle(cloth_, readily, untangling_step * mean_edge(), job, q_);
}

void Draping::settle_freely(const Job& job) {
  if (contact_) contact_->set_stiffness(stiffness_);
  std::vector<Form*> freely = forms();
  std::erase(freely, &layers_);
  NewtonOptions options{.tolerance = free_accuracy, .max_iterations = free_iterations};
  options.longest_step *= std::max(1.0, extent_ / usual_extent);
  newton(problem(std::move(freely)), options, job, q_);
}

void Draping::fit(const Vector& q) {
  if (layers_.fits(q, matrix_)) return;
  std::vector<std::vector<int>> couplings = elastic_.couplings();
  const std::vector<std::vector<int>> touching = layers_.couplings(q);
  couplings.insert(couplings.end(), touching.begin(), touching.end());
  matrix_ = SparseMatrix(matrix_.reduced(), couplings);
  analyse();
}

void Draping::analyse() {
  matrix_ = matrix_.reordered(cholesky_.good_order(matrix_));
  elastic_.prepare(matrix_);
  cholesky_.analyse_in_order(matrix_);
}

double Draping::uncarried(const Vector& gradient) const {
  double sum = 0;
  for (int v = 0; v < cloth_.vertex_count; ++v) sum += gradient[3 * v + 2];
  return sum;
}

bool Draping::falls_for_ever(const Vector& q) const {
  if (!weighs() || !contact_ || holds_ || is_floor_) return false;
  for (int v = 0; v < cloth_.vertex_count; ++v) {
    if (q[3 * v + 2] > lowest_of_body_ - out_of_touch) return false;
  }
  return true;
}

NewtonProblem Draping::problem(std::vector<Form*> forms) {
  return {std::move(forms),
          &matrix_,
          &cholesky_,
          inertia(),
          3 * cloth_.vertex_count,
          [this](const Vector& gradient, const Vector& q) { return relative_residual(gradient, q); },
          [this](const Vector& q) { fit(q); },
          [this](const Vector& q) { return falls_for_ever(q); }};
}

NewtonOutcome Draping::solve_newton(const Job& job) {
  analyse();
  untangle(job);
  if (contact_) contact_->set_stiffness(stiffness_);
  NewtonOptions newton_options{.tolerance = options_.accuracy, .max_iterations = options_.max_iterations};
  newton_options.longest_step *= std::max(1.0, extent_ / usual_extent);
  if (options_.carried_over) newton_options.rate = carried_rate;
  return newton(problem(forms()), newton_options, job, q_);
}

NewtonOutcome Draping::solve_okabe(const Job& job) {
  if (contact_) contact_->set_stiffness(stiffness_);
  const std::vector<Form*> terms = forms();
  OkabeOptions options{.max_iterations = 200 * options_.max_iterations};
  options.first_step = 1e-4;
  options.stop = [&](const Vector& gradient, const Vector& q, int iteration) {
    if (iteration % 100 != 0) return false;
    const double residual = relative_residual(gradient, q);
    if (job.report) job.report({"draping", 0, iteration, residual});
    return residual <= options_.accuracy || job.is_cancelled();
  };
  const OkabeOutcome outcome = okabe(
      [&](const Vector& q, Vector& gradient) {
        gradient.setZero(q.size());
        double energy = 0;
        for (Form* form : terms) {
          form->accept(q);
          energy += form->energy(q, &gradient);
        }
        for (std::size_t i = 0; i < matrix_.reduced().size(); ++i) {
          if (matrix_.reduced()[i] < 0) gradient[static_cast<Eigen::Index>(i)] = 0;
        }
        return energy;
      },
      options, q_);
  Vector gradient = Vector::Zero(q_.size());
  for (Form* form : terms) form->energy(q_, &gradient);
  clear_held(gradient, matrix_.reduced());
  const double residual = relative_residual(gradient, q_);
  return {residual <= options_.accuracy, job.is_cancelled(), outcome.iterations, residual, 0};
}

void Draping::show_rest() {
  fit(q_);
  elastic_.foresee(q_, Vector::Zero(q_.size()));
  // At rest the true Hessian is definite but for motions that nothing resists: the least lift that serves.
  for (double lift = lowest_rest_lift; lift < highest_rest_lift; lift *= 10) {
    matrix_.set_zero();
    for (const Form* form : forms()) form->add_hessian(q_, Curvature::Full, matrix_);
    matrix_.add_diagonal(inertia(), lift);
    if (!cholesky_.factorise(matrix_)) continue;
    options_.at_rest({elastic_, q_, weighs() ? gravity_.weight() / cloth_.area : 0,
                      [this](const Vector& load) { return cholesky_.solve_free(matrix_, load); }});
    return;
  }
}

Drape Draping::run(const Job& job) {
  const NewtonOutcome outcome = options_.solver == DrapeOptions::Solver::Okabe ? solve_okabe(job) : solve_newton(job);
  if (options_.at_rest && outcome.converged && layered()) show_rest();
  Drape drape = describe({cloth_, laws_, elastic_, weighs() ? &gravity_ : nullptr, contact_.get(),
                          layered() ? &layers_ : nullptr, matrix_.reduced(), q_});
  drape.converged = outcome.converged;
  drape.cancelled = outcome.cancelled;
  drape.iterations = outcome.iterations;
  drape.factorisations = cholesky_.factorisations();
  drape.residual_relative = outcome.residual;
  drape.crossing_pairs = intersecting_triangle_pairs(cloth_, drape.positions);
  drape.fell_off = !drape.converged && falls_for_ever(q_);
  drape.trouble = trouble(drape);
  return drape;
}

}  // namespace

Drape drape(const Cloth& cloth, const std::vector<FabricSheet>& fabrics, const Body* body, const Placed& start,
            const DrapeOptions& options, const Job& job) {
  return Draping(cloth, fabrics, body, start, options).run(job);
}

Drape drape(const Cloth& cloth, const FabricSheet& fabric, const Body* body, const Placed& start,
            const DrapeOptions& options, const Job& job) {
  return drape(cloth, std::vector<FabricSheet>(index(cloth.fabric_count()), fabric), body, start, options, job);
}

}  // namespace toile
