// Contact of the cloth with itself: layers have a thickness, resist being pressed together as cloth does (little at
// first, then without bound), rub on each other as on a body, and never pass through each other.
#pragma once

#include <array>
#include <vector>

#include "runtime/contact/grip.hpp"
#include "runtime/contact/neighbours.hpp"
#include "runtime/contact/proximity.hpp"
#include "runtime/mesh/cloth.hpp"
#include "runtime/solve/form.hpp"

namespace toile {

/// Corners with triangles and edges with edges that are nearer than the gap have an energy that grows without bound as
/// their distance goes to nothing: area * pressure * gap * (1 - y)^2 (-ln y), y = distance / gap (the barrier of Li et
/// al., Incremental Potential Contact, 2020, with the pressure for scale). A state without crossings stays so when
/// every step is cut to its free fraction.
class SelfContact : public Form {
 public:
  /// `gap` [m]: distance at which layers touch, of each fabric, between two the mean; less where triangles are small
  /// beside it. `pressure` [Pa]: about three times of it press two layers to half their distance.
  SelfContact(const Cloth& cloth, const std::vector<double>& gaps, double pressure);
  SelfContact(const Cloth& cloth, double gap, double pressure);

  /// The coefficient of each fabric on its own; between two the mean. Without, layers slide freely.
  void set_friction(const std::vector<double>& frictions);
  /// Vertices about crossings that could not be undone: between them contact would keep the cloth crossed, and is left
  /// out.
  void leave_out(std::vector<bool> vertices);

  double energy(const Vector& q, Vector* gradient) const override;
  void add_hessian(const Vector& q, Curvature curvature, SparseMatrix& matrix) const override;
  double free_fraction(const Vector& q, const Vector& step) const override;
  void accept(const Vector& q) override;
  /// What of the energy is friction's [J].
  double friction_energy(const Vector& q) const;

  /// True when the matrix has a place for everything that touches at q.
  bool fits(const Vector& q, const SparseMatrix& matrix) const;
  /// The unknowns coupled by what touches at q, or nearly does.
  std::vector<std::vector<int>> couplings(const Vector& q) const;

 private:
  struct Touch {
    Pair pair;
    Quad x;
    Proximity near;
    double gap = 0;
    double area = 0;      // [m2] that the pair stands for
    double parallel = 0;  // [m4] of edges: below this crossing they are near to parallel
  };
  /// Where two layers touched at the solver's latest rest: a place of the one keeps hold of a place of the other.
  struct Hold {
    Pair pair;
    std::array<double, 4> weights{};  // their difference is the weighted sum of the four vertices
    Grip grip;
    Vector3 apart(const Vector& q) const;
  };
  /// The energy per area and pressure as a function of the distance, and its derivatives by it.
  struct Barrier {
    double value = 0, slope = 0, bend = 0;
  };

  void gather(const Vector& from, const Vector& to) const;
  bool gathered(const Vector& q) const;
  const std::vector<Touch>& touches(const Vector& q) const;
  std::vector<Touch> within(const Vector& q, double times_gap) const;
  double gap_of(const Pair& pair) const;
  double area_of(const Pair& pair) const;
  double parallel_of(const Pair& pair) const;
  double friction_of(const Pair& pair) const;
  Barrier barrier(const Touch& touch) const;
  /// How much of the barrier counts.
  double counted_share(const Touch& touch) const;
  Vector12 gradient(const Touch& touch) const;
  Matrix12 hessian(const Touch& touch, Curvature curvature) const;

  const Cloth& cloth_;
  double pressure_;
  double widest_gap_;
  std::vector<double> gap_;             // [m] per vertex
  std::vector<double> widest_;          // [m] per vertex: what the gap is at most for the size of its triangles
  std::vector<double> friction_;        // [1] per vertex; empty: none
  std::vector<bool> left_out_;          // per vertex; empty: none
  std::vector<double> area_of_edge_;    // [m2]
  std::vector<double> square_of_edge_;  // [m2] of its length
  double slack_;                        // [m]
  std::vector<Hold> holds_;             // in the order of touches
  // Neighbours hold for every q between the two places, or within the slack of them.
  mutable Vector swept_from_, swept_to_;
  mutable std::vector<Pair> neighbours_;
  // Of the latest q: energy, gradient and Hessian are asked for at the same place.
  mutable Vector measured_at_;
  mutable std::vector<Touch> touches_;
};

}  // namespace toile
