#include "runtime/develop/coarse_start.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/develop/flattening.hpp"
#include "runtime/develop/flips.hpp"
#include "runtime/develop/lattice.hpp"
#include "runtime/mesh/index.hpp"
#include "runtime/solve/sparse.hpp"

namespace toile {
namespace {

/// How fine the lattice is, for a pattern of so many triangles.
struct Fineness {
  std::size_t from;     // triangles
  int cells;            // along the longer side of a piece
  std::size_t samples;  // triangles that stand for the whole pattern, about
};
constexpr Fineness coarse{0, 8, 500}, fine{12000, 16, 1500};

constexpr std::size_t fewest = 1000;  // triangles of a pattern that it is worth it for
constexpr int most_iterations = 16;
constexpr int lattice_halvings = 20;
constexpr double enough = 1e-2;          // fall of the energy in a step, relative, that ends it
constexpr double link_smoothing = 1e-6;  // stiffness between neighbours of the lattice over the cloth's own

/// A triangle that stands for those about it. Its sides are moved as the lattice's slopes in its middle say: `weights`
/// are those of each node for the far corners of its first and its last side.
struct Sample {
  int patch = 0;
  PlaneCorners start;
  std::array<std::array<double, Lattice::held_by>, 2> weights{};
  TargetTriangle target;
};

class CoarseStart {
 public:
  CoarseStart(const FlatteningInput& input, const FabricLaw& law)
      : input_(input),
        law_(law),
        fineness_(input.triangles.size() < fine.from ? coarse : fine),
        lattice_(input, fineness_.cells) {
    take_samples();
    hold_grain();
  }

  std::vector<Vec2> find() {
    SparseMatrix matrix(all_free(), couplings());
    for (int patch = 0; patch < lattice_.patches(); ++patch) {
      places_.push_back(matrix.places(unknowns(lattice_.nodes_of(patch))));
    }
    Cholesky cholesky;
    cholesky.analyse_in_order(matrix);  // nodes of a row after those of another: a band
    Vector c = Vector::Zero(2 * lattice_.nodes()), gradient, trial_gradient;
    std::vector<FlatTriangle> flat, trial_flat;
    double now = energy(c, gradient, flat);
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      assemble(flat, matrix);
      if (!cholesky.factorise(matrix)) break;
      const Vector step = along_grain(cholesky.solve(-gradient), cholesky);
      const double before = now, slope = gradient.dot(step);
      double fraction = longest_step(c, step);
      for (int halving = 0; halving < lattice_halvings; ++halving, fraction *= 0.5) {
        const Vector trial = c + fraction * step;
        const double then = energy(trial, trial_gradient, trial_flat);
        if (!std::isfinite(then) || then > now + 1e-4 * fraction * slope) continue;
        c = trial;
        now = then;
        gradient.swap(trial_gradient);
        flat.swap(trial_flat);
        break;
      }
      if (!(now < (1 - enough) * before)) break;
    }
    return moved(c);
  }

 private:
  static constexpr int moved_by = 2 * static_cast<int>(Lattice::held_by);  // unknowns of a patch
  using OfPatch = Eigen::Matrix<double, moved_by, moved_by, Eigen::RowMajor>;

  void take_samples() {
    const std::size_t stride = std::max<std::size_t>(1, input_.triangles.size() / fineness_.samples);
    for (std::size_t t = stride / 2; t < input_.triangles.size(); t += stride) {
      const std::array<int, 3>& corners = input_.triangles[t];
      const auto space = [&](std::size_t i) { return input_.target[index(corners[i])]; };
      const auto plane = [&](std::size_t i) { return input_.start[index(corners[i])]; };
      const auto target = target_triangle({space(0), space(1), space(2)});
      if (!target) continue;
      Sample sample;
      sample.patch = lattice_.patch_of(corners[0]);
      sample.start = {plane(0), plane(1), plane(2)};
      sample.target = *target;
      const auto slopes = lattice_.slopes(corners[0], (plane(0) + plane(1) + plane(2)) / 3);
      for (std::size_t k = 0; k < Lattice::held_by; ++k) {
        sample.weights[0][k] = dot(slopes[k], plane(1) - plane(0));
        sample.weights[1][k] = dot(slopes[k], plane(2) - plane(0));
      }
      samples_.push_back(sample);
    }
    const double stiffness = 0.5 * (law_.warp.initial_stiffness() + law_.weft.initial_stiffness());
    const auto all = static_cast<double>(std::max<std::size_t>(1, input_.triangles.size()));
    link_stiffness_ = link_smoothing * stiffness * static_cast<double>(samples_.size()) / all;
  }

  /// How far across the warp the far end of each grain line moves from its near one.
  void hold_grain() {
    across_ = Vector::Zero(2 * lattice_.nodes());
    for (const FlatteningInput::GrainLine& line : input_.grain) {
      for (const auto& [point, sign] : {std::pair{line.to, 1.0}, std::pair{line.from, -1.0}}) {
        const Lattice::Nodes& nodes = lattice_.nodes_of(lattice_.patch_of(point));
        const auto shares = lattice_.shares(point);
        for (std::size_t k = 0; k < Lattice::held_by; ++k) across_[2 * nodes[k] + 1] += sign * shares[k];
      }
    }
    piece_of_node_.assign(index(lattice_.nodes()), 0);
    for (std::size_t p = 0; p < input_.start.size(); ++p) {
      const int point = static_cast<int>(p);
      for (const int node : lattice_.nodes_of(lattice_.patch_of(point))) {
        piece_of_node_[index(node)] = lattice_.piece_of(point);
      }
    }
  }

  /// The step that is best among those which leave the grain lines where they run: pieces do not touch each other here,
  /// so that each piece is put right by itself.
  Vector along_grain(Vector step, const Cholesky& cholesky) const {
    const Vector pulled = cholesky.solve(across_);
    std::vector<double> off, give;
    for (Eigen::Index i = 0; i < step.size(); ++i) {
      const std::size_t piece = index(piece_of_node_[static_cast<std::size_t>(i / 2)]);
      if (piece >= off.size()) {
        off.resize(piece + 1, 0.0);
        give.resize(piece + 1, 0.0);
      }
      off[piece] += across_[i] * step[i];
      give[piece] += across_[i] * pulled[i];
    }
    for (Eigen::Index i = 0; i < step.size(); ++i) {
      const std::size_t piece = index(piece_of_node_[static_cast<std::size_t>(i / 2)]);
      if (give[piece] > 0) step[i] -= off[piece] / give[piece] * pulled[i];
    }
    return step;
  }

  template <class Nodes>
  static std::vector<int> unknowns(const Nodes& nodes) {
    std::vector<int> all;
    for (const int node : nodes) {
      all.push_back(2 * node);
      all.push_back(2 * node + 1);
    }
    return all;
  }
  std::vector<int> all_free() const {
    std::vector<int> free(2 * index(lattice_.nodes()));
    std::iota(free.begin(), free.end(), 0);
    return free;
  }
  std::vector<std::vector<int>> couplings() const {
    std::vector<std::vector<int>> all;
    for (int patch = 0; patch < lattice_.patches(); ++patch) all.push_back(unknowns(lattice_.nodes_of(patch)));
    for (const auto& link : lattice_.links()) all.push_back(unknowns(link));
    return all;
  }

  PlaneCorners corners(const Vector& c, const Sample& sample, bool from_start) const {
    PlaneCorners uv = from_start ? sample.start : PlaneCorners{};
    const Lattice::Nodes& nodes = lattice_.nodes_of(sample.patch);
    for (std::size_t k = 0; k < Lattice::held_by; ++k) {
      const Vec2 shift{c[2 * nodes[k]], c[2 * nodes[k] + 1]};
      uv[1] = uv[1] + sample.weights[0][k] * shift;
      uv[2] = uv[2] + sample.weights[1][k] * shift;
    }
    return uv;
  }

  double energy(const Vector& c, Vector& gradient, std::vector<FlatTriangle>& flat) const {
    flat.clear();
    gradient.setZero(c.size());
    double sum = 0;
    for (const Sample& sample : samples_) {
      flat.emplace_back(law_, sample.target, corners(c, sample, true));
      sum += flat.back().whole_energy();
      const Vector6 slope = flat.back().gradient();
      const Lattice::Nodes& nodes = lattice_.nodes_of(sample.patch);
      for (std::size_t k = 0; k < Lattice::held_by; ++k) {
        gradient.segment<2>(2 * nodes[k]) +=
            sample.weights[0][k] * slope.segment<2>(2) + sample.weights[1][k] * slope.segment<2>(4);
      }
    }
    for (const auto& [a, b] : lattice_.links()) {
      const Eigen::Vector2d apart = c.segment<2>(2 * a) - c.segment<2>(2 * b);
      sum += 0.5 * link_stiffness_ * apart.squaredNorm();
      gradient.segment<2>(2 * a) += link_stiffness_ * apart;
      gradient.segment<2>(2 * b) -= link_stiffness_ * apart;
    }
    return sum;
  }

  void assemble(const std::vector<FlatTriangle>& flat, SparseMatrix& matrix) const {
    matrix.set_zero();
    std::vector<OfPatch> of_patches(places_.size(), OfPatch::Zero());
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      const Sample& sample = samples_[s];
      const Matrix6 hessian = flat[s].hessian(Curvature::PositiveDefinite);
      const Eigen::Matrix4d sides = hessian.bottomRightCorner<4, 4>();
      // First by the nodes on one side, then on the other.
      Eigen::Matrix<double, 4, moved_by, Eigen::RowMajor> half;
      const auto &first = sample.weights[0], &last = sample.weights[1];
      for (int b = 0; b < moved_by; ++b) {
        half.col(b) = first[index(b / 2)] * sides.col(b % 2) + last[index(b / 2)] * sides.col(2 + b % 2);
      }
      OfPatch& sum = of_patches[index(sample.patch)];
      for (int a = 0; a < moved_by; ++a) {
        sum.row(a) += first[index(a / 2)] * half.row(a % 2) + last[index(a / 2)] * half.row(2 + a % 2);
      }
    }
    for (std::size_t patch = 0; patch < of_patches.size(); ++patch) {
      std::size_t place = 0;
      for (int a = 0; a < moved_by; ++a) {
        for (int b = 0; b <= a; ++b, ++place) matrix.add_at(places_[patch][place], of_patches[patch](a, b));
      }
    }
    for (const auto& [a, b] : lattice_.links()) {
      for (const int i : {0, 1}) {
        matrix.add(2 * a + i, 2 * a + i, link_stiffness_);
        matrix.add(2 * b + i, 2 * b + i, link_stiffness_);
        matrix.add(2 * a + i, 2 * b + i, -link_stiffness_);
      }
    }
    // Nothing holds the whole in its place.
    const std::vector<double> ones(2 * index(lattice_.nodes()), 1.0);
    matrix.add_diagonal(ones, 1e-3 * link_stiffness_);
  }

  double longest_step(const Vector& c, const Vector& step) const {
    double longest = 1;
    for (const Sample& sample : samples_) {
      longest = std::min(longest, step_before_flip(corners(c, sample, true), corners(step, sample, false)));
    }
    return longest;
  }

  std::vector<Vec2> moved(const Vector& c) const {
    std::vector<Vec2> places = input_.start;
    for (std::size_t p = 0; p < places.size(); ++p) {
      const int point = static_cast<int>(p);
      const Lattice::Nodes& nodes = lattice_.nodes_of(lattice_.patch_of(point));
      const auto shares = lattice_.shares(point);
      for (std::size_t k = 0; k < Lattice::held_by; ++k) {
        places[p] = places[p] + shares[k] * Vec2{c[2 * nodes[k]], c[2 * nodes[k] + 1]};
      }
    }
    const bool sound = std::all_of(input_.triangles.begin(), input_.triangles.end(), [&](const auto& t) {
      return turn({places[index(t[0])], places[index(t[1])], places[index(t[2])]}) > 0;
    });
    return sound ? places : input_.start;
  }

  const FlatteningInput& input_;
  const FabricLaw& law_;
  const Fineness fineness_;
  const Lattice lattice_;
  std::vector<Sample> samples_;
  std::vector<std::vector<std::int32_t>> places_;  // of each patch
  Vector across_;
  std::vector<int> piece_of_node_;
  double link_stiffness_ = 0;
};

}  // namespace

std::vector<Vec2> coarse_start(const FlatteningInput& input, const FabricLaw& law) {
  if (input.triangles.size() < fewest) return input.start;
  return CoarseStart(input, law).find();
}

}  // namespace toile
