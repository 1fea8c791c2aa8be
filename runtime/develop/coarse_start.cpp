#include "runtime/develop/coarse_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "runtime/develop/flattening.hpp"
#include "runtime/develop/flips.hpp"
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
constexpr int most_iterations = 12;
constexpr int lattice_halvings = 20;
constexpr double enough = 1e-2;          // fall of the energy in a step, relative, that ends it
constexpr double link_smoothing = 1e-3;  // stiffness between neighbours of the lattice over the cloth's own

struct Lattice {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  double cell = 1;
  int columns = 1, first = 0;
};

/// Where a point lies in its lattice.
struct Hold {
  std::array<int, 4> nodes{};
  std::array<double, 4> weights{};
};

/// A sampled triangle: the nodes that move it, each with its weight at the three corners.
struct Sample {
  std::size_t triangle = 0;
  std::vector<int> nodes;
  std::vector<std::array<double, 3>> weights;
  std::vector<std::int32_t> places;
  TargetTriangle target;
};

class CoarseStart {
 public:
  CoarseStart(const FlatteningInput& input, const FabricLaw& law)
      : input_(input), law_(law), fineness_(input.triangles.size() < fine.from ? coarse : fine) {
    find_pieces();
    lay_lattices();
    take_samples();
  }

  std::vector<Vec2> find() {
    SparseMatrix matrix(all_free(), couplings());
    for (Sample& sample : samples_) sample.places = matrix.places(unknowns(sample));
    Cholesky cholesky;
    cholesky.analyse(matrix);
    Vector c = Vector::Zero(2 * nodes_), gradient;
    double now = energy(c, &gradient);
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      assemble(c, matrix);
      if (!cholesky.factorise(matrix)) break;
      const Vector step = cholesky.solve(-gradient);
      const double before = now;
      double fraction = longest_step(c, step);
      for (int halving = 0; halving < lattice_halvings; ++halving, fraction *= 0.5) {
        const Vector trial = c + fraction * step;
        const double then = energy(trial, nullptr);
        if (!std::isfinite(then) || then > now + 1e-4 * fraction * gradient.dot(step)) continue;
        c = trial;
        break;
      }
      now = energy(c, &gradient);
      if (!(now < (1 - enough) * before)) break;
    }
    return moved(c);
  }

 private:
  std::size_t count() const { return input_.start.size(); }

  void find_pieces() {
    piece_.resize(count());
    std::iota(piece_.begin(), piece_.end(), 0);
    const auto root = [&](int p) {
      while (piece_[index(p)] != p) p = piece_[index(p)] = piece_[index(piece_[index(p)])];
      return p;
    };
    for (const auto& t : input_.triangles) {
      piece_[index(root(t[1]))] = root(t[0]);
      piece_[index(root(t[2]))] = root(t[0]);
    }
    std::vector<int> number(count(), -1);
    for (std::size_t p = 0; p < count(); ++p) {
      int& n = number[index(root(static_cast<int>(p)))];
      if (n < 0) {
        n = static_cast<int>(lattices_.size());
        lattices_.emplace_back();
      }
    }
    std::vector<int> found(count());
    for (std::size_t p = 0; p < count(); ++p) found[p] = number[index(root(static_cast<int>(p)))];
    piece_ = std::move(found);
  }

  void lay_lattices() {
    for (std::size_t p = 0; p < count(); ++p) {
      Lattice& lattice = lattices_[index(piece_[p])];
      const Vec2 at = input_.start[p];
      lattice.low = {std::min(lattice.low.x, at.x), std::min(lattice.low.y, at.y)};
      lattice.high = {std::max(lattice.high.x, at.x), std::max(lattice.high.y, at.y)};
    }
    for (Lattice& lattice : lattices_) {
      const Vec2 extent = lattice.high - lattice.low;
      lattice.cell = std::max(std::max(extent.x, extent.y) / fineness_.cells, 1e-9);
      lattice.columns = static_cast<int>(extent.x / lattice.cell) + 2;
      const int rows = static_cast<int>(extent.y / lattice.cell) + 2;
      lattice.first = nodes_;
      for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < lattice.columns; ++i) {
          const int node = nodes_ + j * lattice.columns + i;
          if (i + 1 < lattice.columns) links_.push_back({node, node + 1});
          if (j + 1 < rows) links_.push_back({node, node + lattice.columns});
        }
      }
      nodes_ += lattice.columns * rows;
    }
    for (std::size_t p = 0; p < count(); ++p) {
      const Lattice& lattice = lattices_[index(piece_[p])];
      const Vec2 at = (input_.start[p] - lattice.low) / lattice.cell;
      const int i = static_cast<int>(at.x), j = static_cast<int>(at.y);
      const double x = at.x - i, y = at.y - j;
      const int node = lattice.first + j * lattice.columns + i;
      const bool right = i + 1 < lattice.columns;
      const int over = right ? 1 : 0, up = y > 0 ? lattice.columns : 0;
      holds_.push_back(
          {{node, node + over, node + up, node + up + over}, {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y}});
    }
  }

  void take_samples() {
    const std::size_t stride = std::max<std::size_t>(1, input_.triangles.size() / fineness_.samples);
    for (std::size_t t = stride / 2; t < input_.triangles.size(); t += stride) {
      Sample sample;
      sample.triangle = t;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Hold& hold = holds_[index(input_.triangles[t][corner])];
        for (std::size_t k = 0; k < 4; ++k) {
          const auto known = std::find(sample.nodes.begin(), sample.nodes.end(), hold.nodes[k]);
          const auto at = static_cast<std::size_t>(known - sample.nodes.begin());
          if (known == sample.nodes.end()) {
            sample.nodes.push_back(hold.nodes[k]);
            sample.weights.push_back({0, 0, 0});
          }
          sample.weights[at][corner] += hold.weights[k];
        }
      }
      const auto corner = [&](std::size_t i) { return input_.target[index(input_.triangles[t][i])]; };
      const auto target = target_triangle({corner(0), corner(1), corner(2)});
      if (!target) continue;
      sample.target = *target;
      samples_.push_back(std::move(sample));
    }
    double area = 0;
    for (const Sample& sample : samples_) area += sample.target.area;
    const double stiffness = 0.5 * (law_.warp.initial_stiffness() + law_.weft.initial_stiffness());
    // A link takes the part of the cloth about it.
    link_stiffness_ =
        link_smoothing * stiffness * area / std::max(1, nodes_) / (lattices_.front().cell * lattices_.front().cell);
  }

  static std::vector<int> unknowns(const std::vector<int>& nodes) {
    std::vector<int> all;
    for (const int node : nodes) {
      all.push_back(2 * node);
      all.push_back(2 * node + 1);
    }
    return all;
  }
  static std::vector<int> unknowns(const Sample& sample) { return unknowns(sample.nodes); }
  std::vector<int> all_free() const {
    std::vector<int> free(2 * index(nodes_));
    std::iota(free.begin(), free.end(), 0);
    return free;
  }
  std::vector<std::vector<int>> couplings() const {
    std::vector<std::vector<int>> all;
    for (const Sample& sample : samples_) all.push_back(unknowns(sample));
    for (const auto& link : links_) all.push_back(unknowns(std::vector<int>{link[0], link[1]}));
    return all;
  }

  Vec2 shift(const Vector& c, const Hold& hold) const {
    Vec2 sum;
    for (std::size_t k = 0; k < 4; ++k) {
      sum = sum + hold.weights[k] * Vec2{c[2 * hold.nodes[k]], c[2 * hold.nodes[k] + 1]};
    }
    return sum;
  }
  PlaneCorners corners(const Vector& c, const Sample& sample, bool from_start) const {
    PlaneCorners uv;
    for (std::size_t k = 0; k < 3; ++k) {
      const int point = input_.triangles[sample.triangle][k];
      uv[k] = shift(c, holds_[index(point)]);
      if (from_start) uv[k] = uv[k] + input_.start[index(point)];
    }
    return uv;
  }

  double energy(const Vector& c, Vector* gradient) const {
    if (gradient != nullptr) gradient->setZero(c.size());
    double sum = 0;
    Vector6 slope;
    for (const Sample& sample : samples_) {
      const MembraneEnergy parts =
          flattening_energy(law_, sample.target, corners(c, sample, true), gradient != nullptr ? &slope : nullptr);
      sum += parts.warp + parts.weft + parts.shear;
      if (gradient == nullptr) continue;
      for (std::size_t n = 0; n < sample.nodes.size(); ++n) {
        for (int k = 0; k < 3; ++k) {
          gradient->segment<2>(2 * sample.nodes[n]) +=
              sample.weights[n][static_cast<std::size_t>(k)] * slope.segment<2>(2 * k);
        }
      }
    }
    for (const auto& [a, b] : links_) {
      const Eigen::Vector2d apart = c.segment<2>(2 * a) - c.segment<2>(2 * b);
      sum += 0.5 * link_stiffness_ * apart.squaredNorm();
      if (gradient == nullptr) continue;
      gradient->segment<2>(2 * a) += link_stiffness_ * apart;
      gradient->segment<2>(2 * b) -= link_stiffness_ * apart;
    }
    return sum;
  }

  void assemble(const Vector& c, SparseMatrix& matrix) const {
    matrix.set_zero();
    for (const Sample& sample : samples_) {
      const Matrix6 hessian =
          flattening_hessian(law_, sample.target, corners(c, sample, true), Curvature::PositiveDefinite);
      // First by the nodes on one side, then on the other.
      const int size = 2 * static_cast<int>(sample.nodes.size());
      Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 24> half(6, size);
      for (int b = 0; b < size; ++b) {
        const std::array<double, 3>& weights = sample.weights[index(b / 2)];
        half.col(b) =
            weights[0] * hessian.col(b % 2) + weights[1] * hessian.col(2 + b % 2) + weights[2] * hessian.col(4 + b % 2);
      }
      std::size_t place = 0;
      for (int a = 0; a < size; ++a) {
        const std::array<double, 3>& weights = sample.weights[index(a / 2)];
        for (int b = 0; b <= a; ++b, ++place) {
          matrix.add_at(sample.places[place], weights[0] * half(a % 2, b) + weights[1] * half(2 + a % 2, b) +
                                                  weights[2] * half(4 + a % 2, b));
        }
      }
    }
    for (const auto& [a, b] : links_) {
      for (const int i : {0, 1}) {
        matrix.add(2 * a + i, 2 * a + i, link_stiffness_);
        matrix.add(2 * b + i, 2 * b + i, link_stiffness_);
        matrix.add(2 * a + i, 2 * b + i, -link_stiffness_);
      }
    }
    // Nothing holds the whole in its place.
    const std::vector<double> ones(2 * index(nodes_), 1.0);
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
    std::vector<Vec2> places;
    for (std::size_t p = 0; p < count(); ++p) places.push_back(input_.start[p] + shift(c, holds_[p]));
    for (const FlatteningInput::GrainLine& line : input_.grain) straighten(line, places);
    const bool sound = std::all_of(input_.triangles.begin(), input_.triangles.end(), [&](const auto& t) {
      return turn({places[index(t[0])], places[index(t[1])], places[index(t[2])]}) > 0;
    });
    return sound ? places : input_.start;
  }

  /// Turns a piece so that its grain line runs as it did.
  void straighten(const FlatteningInput::GrainLine& line, std::vector<Vec2>& places) const {
    const Vec2 was = input_.start[index(line.to)] - input_.start[index(line.from)];
    const Vec2 is = places[index(line.to)] - places[index(line.from)];
    const double angle = std::atan2(cross(is, was), dot(is, was));
    const Vec2 along = direction(angle), from = places[index(line.from)];
    for (std::size_t p = 0; p < count(); ++p) {
      if (piece_[p] != piece_[index(line.from)]) continue;
      const Vec2 way = places[p] - from;
      places[p] = from + way.x * along + way.y * perpendicular(along);
    }
  }

  const FlatteningInput& input_;
  const FabricLaw& law_;
  const Fineness fineness_;
  std::vector<int> piece_;  // of each point
  std::vector<Lattice> lattices_;
  std::vector<std::array<int, 2>> links_;
  std::vector<Hold> holds_;
  std::vector<Sample> samples_;
  int nodes_ = 0;
  double link_stiffness_ = 0;
};

}  // namespace

std::vector<Vec2> coarse_start(const FlatteningInput& input, const FabricLaw& law) {
  if (input.triangles.size() < fewest) return input.start;
  return CoarseStart(input, law).find();
}

}  // namespace toile
