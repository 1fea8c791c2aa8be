#include "runtime/laboratory/rig.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/energy/gravity.hpp"
#include "runtime/solve/newton.hpp"

namespace toile {
namespace {

constexpr double grip_share = 1e4;     // of the bending rigidity over an edge's length: the jaw leans by that much less
constexpr double least_weight = 0.05;  // [kg/m2] of the proximal term's mass

std::vector<int> reduced_unknowns(const Specimen& specimen, const ClothUnknowns& unknowns,
                                  const HeldCoordinates& held) {
  std::vector<int> reduced(static_cast<std::size_t>(unknowns.count()), 0);
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    const std::array<bool, 3> is_held = held(specimen.points[v]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_held[k]) reduced[3 * v + k] = -1;
    }
  }
  int next = 0;
  for (int& r : reduced) {
    if (r == 0) r = next++;
  }
  return reduced;
}

double edge_of(const Cloth& cloth) {
  return std::sqrt(4 / std::sqrt(3.0) * cloth.area /
                   static_cast<double>(std::max<std::size_t>(cloth.triangles.size(), 1)));
}

}  // namespace

double DeadLoad::energy(const Vector& q, Vector* gradient) const {
  if (gradient != nullptr) *gradient -= forces;
  return -forces.dot(q);
}

Rig::Rig(const Specimen& specimen, const FabricLaw& law, const HeldCoordinates& held, Loops loops)
    : elastic(specimen.cloth, law, loops),
      jaws(grip_share * std::max(law.bend_warp.rigidity, law.bend_weft.rigidity) / edge_of(specimen.cloth)),
      specimen_(specimen),
      law_(law),
      matrix_(reduced_unknowns(specimen, elastic.unknowns(), held), elastic.couplings()) {
  elastic.prepare(matrix_);
  cholesky_.analyse(matrix_);
  q = Vector::Zero(elastic.unknowns().count());
  load.forces = Vector::Zero(q.size());
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    put(static_cast<int>(v), {specimen.points[v].x, specimen.points[v].y, 0});
  }
}

std::vector<int> Rig::clamp(const std::function<bool(Vec2 at)>& where, const Vector3& plane) {
  std::vector<int> numbers;
  for (std::size_t h = 0; h < elastic.hinges().size(); ++h) {
    const ClothHinge& hinge = elastic.hinges()[h];
    if (hinge.vertices[3] >= 0) continue;
    const Vec2 a = specimen_.points[static_cast<std::size_t>(hinge.vertices[0])];
    const Vec2 b = specimen_.points[static_cast<std::size_t>(hinge.vertices[1])];
    if (!where(0.5 * (a + b))) continue;
    numbers.push_back(jaws.hold(hinge, elastic.unknowns().rotation(static_cast<int>(h)), distance(a, b), plane));
  }
  return numbers;
}

std::vector<Form*> Rig::all() {
  std::vector<Form*> forms{&elastic, &jaws};
  forms.insert(forms.end(), others_.begin(), others_.end());
  return forms;
}

bool Rig::solve(double typical, double tolerance, int max_iterations) {
  const double arm = mean_edge();
  const double mass = std::max(law_.weight, least_weight);
  std::vector<double> inertia;
  for (const double area : specimen_.cloth.area_of_vertex) inertia.insert(inertia.end(), 3, mass * area);
  inertia.resize(static_cast<std::size_t>(q.size()),
                 0.1 * mass * specimen_.cloth.area / std::max(specimen_.cloth.edge_count, 1) * arm * arm);
  const int coordinates = 3 * specimen_.cloth.vertex_count;
  std::vector<Form*> forms = all();
  forms.push_back(&load);
  const auto residual = [&](const Vector& gradient, const Vector&) {
    const double force = gradient.head(coordinates).lpNorm<Eigen::Infinity>();
    const double moment = gradient.tail(gradient.size() - coordinates).lpNorm<Eigen::Infinity>();
    return std::max(force, moment / arm) / typical;
  };
  const NewtonProblem problem{forms, &matrix_, &cholesky_, inertia, coordinates, residual, {}};
  const NewtonOptions options{.tolerance = tolerance, .max_iterations = max_iterations, .rate = 1.0};
  const bool converged = newton(problem, options, {}, q).converged;
  elastic.remember(q);
  return converged;
}

bool Rig::stable() {
  matrix_.set_zero();
  for (const Form* form : all()) form->add_hessian(q, Curvature::Full, matrix_);
  return cholesky_.factorise(matrix_);
}

Vector Rig::forces() {
  Vector forces = Vector::Zero(q.size());
  for (const Form* form : all()) form->energy(q, &forces);
  return forces;
}

double Rig::energy() {
  double energy = load.energy(q, nullptr);
  for (const Form* form : all()) energy += form->energy(q, nullptr);
  return energy;
}

void Rig::weigh(double share) {
  for (std::size_t v = 0; v < specimen_.points.size(); ++v) {
    load.forces[static_cast<Eigen::Index>(3 * v + 2)] =
        -share * law_.weight * specimen_.cloth.area_of_vertex[v] * standard_gravity;
  }
}

double Rig::mean_edge() const {
  return edge_of(specimen_.cloth);
}

}  // namespace toile
