#include "runtime/drape/drape.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "runtime/contact/body_contact.hpp"
#include "runtime/contact/self_contact.hpp"
#include "runtime/contact/self_intersections.hpp"
#include "runtime/contact/untangle.hpp"
#include "runtime/drape/describe.hpp"
#include "runtime/energy/elastic.hpp"
#include "runtime/energy/gravity.hpp"
#include "runtime/mesh/index.hpp"
#include "runtime/solve/newton.hpp"
#include "runtime/solve/okabe.hpp"

namespace toile {
namespace {

constexpr double untangling_rate = 1e4;   // [1/s2] how far a push against a crossing spreads
constexpr double untangling_step = 0.05;  // of the mean edge
constexpr double carried_rate = 30;       // [1/s2] a form that was carried over needs little holding back

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

std::vector<double> vertex_masses(const Cloth& cloth, double weight) {
  std::vector<double> masses;
  masses.reserve(cloth.area_of_vertex.size());
  for (const double area : cloth.area_of_vertex) masses.push_back(weight * area);
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
  Draping(const Cloth& cloth, const FabricSheet& fabric, const Body* body, const Placed& start,
          const DrapeOptions& options)
      : cloth_(cloth),
        law_(softened(make_law(fabric), options.membrane)),
        options_(options),
        elastic_(cloth, law_),
        gravity_(vertex_masses(cloth, law_.weight)),
        layers_(cloth, std::max(law_.thickness, options.least_gap), law_.pressure),
        matrix_(reduced_unknowns(elastic_.unknowns(), start.held), elastic_.couplings()) {
    if (body != nullptr) {
      contact_ = std::make_unique<BodyContact>(cloth, *body, law_.thickness / 2,
                                               options.friction ? body->spec().friction.value_or(law_.friction) : 0);
      stiffness_ = body->spec().softness;
    }
    q_ = Vector::Zero(elastic_.unknowns().count());
    for (int v = 0; v < cloth.vertex_count; ++v) {
      q_.segment<3>(3 * v) = to_eigen(start.positions[static_cast<std::size_t>(v)]);
    }
    if (!options.carried_over) disturb(q_, matrix_.reduced(), cloth.vertex_count, 0.02 * mean_edge());
    weight_per_vertex_ = weighs() ? gravity_.weight() / std::max(cloth.vertex_count, 1) : 0;
  }

  Drape run(const Job& job);

 private:
  bool weighs() const { return options_.gravity; }
  /// The paper's method moves every variable by itself and knows nothing of crossings.
  bool layered() const { return options_.solver == DrapeOptions::Solver::Newton; }
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
  /// Gives the matrix places for the layers that touch at q.
  void fit(const Vector& q);
  /// Puts the matrix into an order that keeps its factor sparse.
  void analyse();
  NewtonOutcome solve_newton(const Job& job);
  NewtonOutcome solve_okabe(const Job& job);

  const Cloth& cloth_;
  FabricLaw law_;
  const DrapeOptions& options_;
  ElasticForm elastic_;
  GravityForm gravity_;
  std::unique_ptr<BodyContact> contact_;
  SelfContact layers_;
  SparseMatrix matrix_;
  Cholesky cholesky_;
  double stiffness_ = 0;
  double weight_per_vertex_ = 0;
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
  const std::vector<double> masses = vertex_masses(cloth_, law_.weight);
  std::vector<double> inertia;
  for (const double mass : masses) inertia.insert(inertia.end(), 3, mass);
  // A rotation is as heavy as the cloth about its edge.
  const double arm = mean_edge();
  const double mean_mass = law_.weight * cloth_.area / std::max(cloth_.edge_count, 1);
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
  const auto readily = [this](const Vector& force) {
    matrix_.set_zero();
    elastic_.add_hessian(q_, Curvature::PositiveDefinite, matrix_);
    matrix_.add_diagonal(inertia(), untangling_rate);
    return cholesky_.factorise(matrix_) ? cholesky_.solve_free(matrix_, force) : force;
  };
  const int left = toile::untangle(cloth_, readily, untangling_step * mean_edge(), job, q_);
  if (left > 0) layers_.leave_out(about_crossings(cloth_, q_));
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

NewtonOutcome Draping::solve_newton(const Job& job) {
  analyse();
  untangle(job);
  NewtonProblem problem{forms(),
                        &matrix_,
                        &cholesky_,
                        inertia(),
                        3 * cloth_.vertex_count,
                        [this](const Vector& gradient, const Vector& q) { return relative_residual(gradient, q); },
                        [this](const Vector& q) { fit(q); }};
  if (contact_) contact_->set_stiffness(stiffness_);
  NewtonOptions newton_options{.tolerance = options_.accuracy, .max_iterations = options_.max_iterations};
  if (options_.carried_over) newton_options.rate = carried_rate;
  return newton(problem, newton_options, job, q_);
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

Drape Draping::run(const Job& job) {
  const NewtonOutcome outcome = options_.solver == DrapeOptions::Solver::Okabe ? solve_okabe(job) : solve_newton(job);
  Drape drape = describe({cloth_, law_, elastic_, weighs() ? &gravity_ : nullptr, contact_.get(),
                          layered() ? &layers_ : nullptr, matrix_.reduced(), q_});
  drape.converged = outcome.converged;
  drape.cancelled = outcome.cancelled;
  drape.iterations = outcome.iterations;
  drape.factorisations = cholesky_.factorisations();
  drape.residual_relative = outcome.residual;
  drape.crossing_pairs = intersecting_triangle_pairs(cloth_, drape.positions);
  drape.trouble = trouble(drape);
  return drape;
}

}  // namespace

Drape drape(const Cloth& cloth, const FabricSheet& fabric, const Body* body, const Placed& start,
            const DrapeOptions& options, const Job& job) {
  return Draping(cloth, fabric, body, start, options).run(job);
}

}  // namespace toile
