// A test bench: a cloth of which some coordinates are held, with dead loads and jaws, brought to equilibrium by the
// energies and the solver that drape garments.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "runtime/laboratory/jaws.hpp"
#include "runtime/laboratory/specimen.hpp"
#include "runtime/solve/sparse.hpp"

namespace toile {

/// What of a vertex is held, by its place on the flat specimen.
using HeldCoordinates = std::function<std::array<bool, 3>(Vec2 at)>;

/// Constant forces on the unknowns.
class DeadLoad : public Form {
 public:
  Vector forces;  // [N]
  double energy(const Vector& q, Vector* gradient) const override;
  void add_hessian(const Vector&, Curvature, SparseMatrix&) const override {}
};

class Rig {
 public:
  Rig(const Specimen& specimen, const FabricLaw& law, const HeldCoordinates& held, Loops loops = Loops::LoadingBranch);
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;

  /// Takes all free edges whose middle is at such places into a jaw and returns the numbers of the holds.
  std::vector<int> clamp(const std::function<bool(Vec2 at)>& where, const Vector3& plane);
  /// Another term of the energy; it must outlive the rig.
  void also(Form& form) { others_.push_back(&form); }

  /// To where no force on a free unknown exceeds `tolerance` of `typical` [N]; false when that was not reached.
  bool solve(double typical, double tolerance = 1e-8, int max_iterations = 300);
  /// Whether every small disturbance takes more energy than it gives.
  bool stable();
  /// The derivative of all terms of the energy but the dead loads by each unknown: at held ones, what holds them [N].
  Vector forces();
  double energy();

  Vector3 at(int vertex) const { return q.segment<3>(3 * vertex); }
  void put(int vertex, const Vector3& place) { q.segment<3>(3 * vertex) = place; }
  /// The weight of the cloth as dead loads, `share` of it.
  void weigh(double share = 1);
  double mean_edge() const;

  Vector q;
  DeadLoad load;
  ElasticForm elastic;
  Jaws jaws;

 private:
  std::vector<Form*> all();

  const Specimen& specimen_;
  FabricLaw law_;
  std::vector<Form*> others_;
  SparseMatrix matrix_;
  Cholesky cholesky_;
};

}  // namespace toile
