// Jaws that hold the rim of a cloth in a given direction: at the middle of each edge held, the cloth's normal is that
// of the jaw. Where the rim is, is for the holder to say: vertices may be held or free.
#pragma once

#include <array>
#include <vector>

#include "runtime/energy/elastic.hpp"
#include "runtime/solve/form.hpp"

namespace toile {

class Jaws : public Form {
 public:
  /// `grip` [N]: moment per length of rim and radian by which the cloth leans out of the jaw.
  explicit Jaws(double grip) : grip_(grip) {}

  /// Takes hold of a free edge. `plane`: a vector from the edge into the jaw. The number of this hold is returned.
  int hold(const ClothHinge& hinge, int rotation, double length, const Vector3& plane);
  void turn(int hold, const Vector3& plane) { holds_[static_cast<std::size_t>(hold)].plane = plane; }
  /// What the jaw turns the rim with, about the edge [N m].
  double moment(int hold, const Vector& q) const;

  double energy(const Vector& q, Vector* gradient) const override;
  void add_hessian(const Vector& q, Curvature curvature, SparseMatrix& matrix) const override;
  void accept(const Vector& q) override;

 private:
  struct Hold {
    std::array<int, 3> vertices{};  // the edge's two, and that opposite
    int rotation = 0;
    double stiffness = 0;  // [N m]
    Vector3 plane = Vector3::Zero();
    double last_angle = 0;
  };
  static Hinge points(const Hold& hold, const Vector& q);
  static double angle(const Hold& hold, const Vector& q);

  double grip_;
  std::vector<Hold> holds_;
};

}  // namespace toile
