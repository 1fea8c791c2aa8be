// The six deformation energies of a whole cloth: elongation, shear, bending and twist of every triangle.
#pragma once

#include <array>
#include <vector>

#include "runtime/energy/bending.hpp"
#include "runtime/energy/dihedral.hpp"
#include "runtime/energy/membrane.hpp"
#include "runtime/mesh/cloth.hpp"
#include "runtime/solve/form.hpp"

namespace toile {

/// An edge at which the surface turns. Wings beyond the second of a T-seam get hinges of their own with one wing: they
/// bend freely there.
struct ClothHinge {
  int edge = 0;
  std::array<int, 4> vertices{};  // as in Hinge; the last is -1 on a free edge
  double crease = 0;              // [rad] its angle at rest, from which all angles are counted
};

/// A triangle's part in the hinge opposite to one of its corners: its angle is tilt * theta / 2 + turn * rotation.
struct HingeSide {
  int hinge = 0;
  double tilt = 0;
  double turn = 1;
};

/// Positions of unknowns: coordinates of vertices first, then the hinges' rotations.
struct ClothUnknowns {
  int vertices = 0;
  int hinges = 0;
  int count() const { return 3 * vertices + hinges; }
  int rotation(int hinge) const { return 3 * vertices + hinge; }
};

struct ElasticParts {  // [J]
  MembraneEnergy stretch;
  BendingEnergy bend;
  double total() const { return stretch.warp + stretch.weft + stretch.shear + bend.warp + bend.weft + bend.twist; }
};

/// How the gradient by some unknowns changes where the corners of a triangle move in the plane (u0, v0, u1, …) and the
/// cloth stays in space. The first nine unknowns are the coordinates of the triangle's corners.
struct PatternCoupling {
  std::vector<int> unknowns;
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 21, 6> by_corners;
};

/// How the friction inside the cloth acts: as on the loading branch everywhere, or with the history of each triangle.
enum class Loops { LoadingBranch, Remembered };

class ElasticForm : public Form {
 public:
  ElasticForm(const Cloth& cloth, const FabricLaw& law, Loops loops = Loops::LoadingBranch);
  /// A law for each fabric of the cloth.
  ElasticForm(const Cloth& cloth, std::vector<FabricLaw> laws, Loops loops = Loops::LoadingBranch);

  const ClothUnknowns& unknowns() const { return unknowns_; }
  const std::vector<ClothHinge>& hinges() const { return hinges_; }
  /// What every triangle and hinge couples: the pattern of the matrix.
  std::vector<std::vector<int>> couplings() const;
  /// Finds the places of all elements in the matrix; call once after building it.
  void prepare(const SparseMatrix& matrix);

  double energy(const Vector& q, Vector* gradient) const override;
  void add_hessian(const Vector& q, Curvature curvature, SparseMatrix& matrix) const override;
  /// Keeps the strains that the step leads to if it were linear. The stresses of those, not the ones that a finite turn
  /// of the threads adds for a moment, make the Hessian at the step's end (after the mixed iteration of Magisano,
  /// Leonetti and Garcea, 2017): steps along folds become several times longer.
  void foresee(const Vector& q, const Vector& step) override;
  void accept(const Vector& q) override;
  /// Takes q into the history of the loops: a step of the test, or of the wearing, ends there.
  void remember(const Vector& q);

  ElasticParts parts(const Vector& q) const;
  /// Per triangle.
  std::vector<MembraneStrain> strains(const Vector& q) const;
  std::vector<Curvatures> curvatures(const Vector& q) const;
  /// One a triangle of the cloth that the form was made of.
  std::vector<PatternCoupling> pattern_couplings(const Cloth& cloth, const Vector& q) const;
  /// Sum over vertices of the norms of what each triangle's membrane puts on them, over the number of vertices [N].
  double mean_internal_force(const Vector& q) const;

 private:
  struct Triangle {
    std::array<int, 3> vertices{};
    MembraneShape membrane;
    BendingShape bending;
    std::array<HingeSide, 3> sides{};
    int fabric = 0;
  };
  struct Element {
    std::vector<int> vertices;                     // the triangle's and its neighbours' far corners, each once
    std::array<std::array<int, 4>, 3> of_hinge{};  // the hinge's points among them
    std::vector<std::int32_t> places;
  };

  const FabricLaw& law(std::size_t triangle) const {
    return laws_[static_cast<std::size_t>(triangles_[triangle].fabric)];
  }
  const ClothMemory* memory(std::size_t triangle) const { return memory_.empty() ? nullptr : &memory_[triangle]; }
  void make_hinges(const Cloth& cloth);
  void make_elements();
  std::vector<int> unknowns_of(const Element& element, const Triangle& triangle) const;
  Hinge hinge_points(const ClothHinge& hinge, const Vector& q) const;
  static Corners corners(const std::array<int, 3>& vertices, const Vector& q);
  double angle(std::size_t hinge, const Vector& q) const;
  std::vector<double> angles(const Vector& q) const;
  using AnglesByUnknowns = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor, 3, 21>;
  /// A triangle's three angles by its element's unknowns; `slopes` are the gradients of the dihedral angles.
  AnglesByUnknowns angles_by_unknowns(std::size_t triangle, const std::vector<Vector12>& slopes) const;
  std::vector<Vector12> dihedral_slopes(const Vector& q) const;
  Angles triangle_angles(const Triangle& triangle, const std::vector<double>& theta, const Vector& q) const;
  void add_triangles(const Vector& q, const std::vector<double>& theta, const std::vector<Vector12>& slopes,
                     Curvature curvature, SparseMatrix& matrix) const;
  void add_hinges(const Vector& q, const std::vector<double>& theta, SparseMatrix& matrix) const;
  std::vector<double> hinge_moments(const Vector& q, const std::vector<double>& theta) const;

  std::vector<FabricLaw> laws_;  // of each fabric
  ClothUnknowns unknowns_;
  std::vector<Triangle> triangles_;
  std::vector<ClothHinge> hinges_;
  std::vector<Element> elements_;
  std::vector<std::vector<std::int32_t>> hinge_places_;
  std::vector<double> last_angle_;   // of each hinge when the solver last came to rest: angles are unwrapped from it
  std::vector<ClothMemory> memory_;  // of each triangle; empty where nothing is remembered
  std::vector<MembraneStrain> foreseen_;  // per triangle; empty before the first step
};

}  // namespace toile
