// Contact of the cloth with a body: E_p = integral of k d^2 / 2 over the cloth inside (paper, section 4), so that the
// pressure is k d whatever the mesh; and Coulomb friction (grip.hpp).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "runtime/body/body.hpp"
#include "runtime/contact/grip.hpp"
#include "runtime/mesh/cloth.hpp"
#include "runtime/solve/form.hpp"

namespace toile {

/// A place of the cloth at which contact is measured: a vertex, the middle of an edge or that of a triangle (so that no
/// body bulges through between vertices).
struct ContactPoint {
  std::array<int, 3> vertices{};  // the place is their mean
  int count = 1;                  // how many of them: 1, 2 or 3
  double area = 0;                // [m2] of the cloth as it lay at the solver's latest rest
  double gap = 0;                 // [m]
  double friction = 0;            // [1]
};

struct ContactForces {
  Vector3 normal = Vector3::Zero(), friction = Vector3::Zero();  // sums on the cloth [N]
  double normal_energy = 0, friction_energy = 0;                 // [J]
  double area = 0;                                               // [m2] in contact
  double max_depth = 0;                                          // [m]
  double max_pressure = 0;                                       // [Pa] there
};

class BodyContact : public Form {
 public:
  /// `gap` [m]: half the cloth's thickness, the distance at which its middle surface touches; of each of its fabrics.
  /// The cloth and the body must outlive it.
  BodyContact(const Cloth& cloth, const Body& body, const std::vector<double>& gaps,
              const std::vector<double>& frictions);
  BodyContact(const Cloth& cloth, const Body& body, double gap, double friction);

  /// Pressure per depth [N/m3].
  void set_stiffness(double stiffness) { stiffness_ = stiffness; }
  double energy(const Vector& q, Vector* gradient) const override;
  void add_hessian(const Vector& q, Curvature curvature, SparseMatrix& matrix) const override;
  void accept(const Vector& q) override;

  ContactForces forces(const Vector& q) const;
  /// Per vertex, the mean over its part of the cloth [Pa]: between vertices a round body comes nearer than at them.
  std::vector<double> pressures(const Vector& q) const;

 private:
  template <class AreaOf>
  void share_out_areas(const AreaOf& area_of);
  void measure_areas(const Vector& q);

  struct Touch {
    bool in = false;
    double depth = 0;                     // [m]
    Vector3 normal = Vector3::Zero();     // the depth's steepest fall; a unit vector but for the body's smoothing
    Matrix3 curvature = Matrix3::Zero();  // [1/m] the clearance's second derivative
  };
  /// Where a point was when it was last measured, and how far it may move before it can touch.
  struct Leeway {
    Vector3 at = Vector3::Zero();
    double free = -1;
  };

  const std::vector<Touch>& touches(const Vector& q) const;
  Vector3 place(const ContactPoint& point, const Vector& q) const;
  Matrix3 normal_block(const Touch& touch, double area, Curvature curvature) const;
  void add_block(const ContactPoint& point, const Matrix3& block, SparseMatrix& matrix) const;

  const Cloth& cloth_;
  const Body& body_;
  int vertices_ = 0;
  bool rubs_ = false;
  double stiffness_ = 1e6;
  std::vector<ContactPoint> points_;
  std::vector<std::optional<Grip>> grips_;  // what of friction lasts from one step of the solver to the next
  // Nearest points of the latest q: energy, gradient and Hessian are asked for at the same place.
  mutable Vector measured_at_;
  mutable std::vector<Touch> touches_;
  mutable std::vector<Leeway> leeway_;
};

}  // namespace toile
