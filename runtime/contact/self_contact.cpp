#include "runtime/contact/self_contact.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "runtime/contact/advance.hpp"
#include "runtime/mesh/index.hpp"
#include "runtime/solve/parallel.hpp"

namespace toile {
namespace {

constexpr double share_of_edge =
    0.25;  // of the mean edge: so far vertices may move before neighbours are looked for again
constexpr double share_of_altitude = 0.4;  // of a triangle's least altitude, which the gap does not exceed
constexpr double soon = 2;                 // times the gap: what is so near gets its place in the matrix
// Edges whose sine is below this are so near to parallel that their corners carry the contact; squared.
constexpr double parallel = 1e-2;
// Of the gap: what is nearer still was so at the start and coincides; no force has a direction there.
constexpr double coincident = 1e-6;

/// Of each vertex, the largest value of the fabrics about it.
std::vector<double> of_vertices(const Cloth& cloth, const std::vector<double>& of_fabric) {
  std::vector<double> values(index(cloth.vertex_count), 0.0);
  for (const ClothTriangle& triangle : cloth.triangles) {
    for (const int v : triangle.vertices) {
      values[index(v)] = std::max(values[index(v)], of_fabric[index(triangle.fabric)]);
    }
  }
  return values;
}

/// Of each vertex, the widest gap that the triangles about it let it have.
std::vector<double> widest_gaps(const Cloth& cloth, double widest) {
  std::vector<double> gaps(index(cloth.vertex_count), widest);
  for (const ClothTriangle& triangle : cloth.triangles) {
    const double twice_area = std::abs(cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0]));
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, norm(triangle.uv[(k + 1) % 3] - triangle.uv[k]));
    for (const int v : triangle.vertices) {
      gaps[index(v)] = std::min(gaps[index(v)], share_of_altitude * twice_area / longest);
    }
  }
  return gaps;
}

std::vector<double> edge_areas(const Cloth& cloth) {
  std::vector<double> areas(index(cloth.edge_count), 0.0);
  for (const ClothTriangle& triangle : cloth.triangles) {
    const double area = 0.5 * std::abs(cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0]));
    for (const int edge : triangle.edges) areas[index(edge)] += area / 3;
  }
  return areas;
}

std::vector<double> edge_squares(const Cloth& cloth) {
  std::vector<double> squares(index(cloth.edge_count), 0.0);
  for (const ClothTriangle& triangle : cloth.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 side = triangle.uv[(k + 2) % 3] - triangle.uv[(k + 1) % 3];
      squares[index(triangle.edges[k])] = dot(side, side);
    }
  }
  return squares;
}

double mean_length(const std::vector<double>& squares) {
  double sum = 0;
  for (const double square : squares) sum += std::sqrt(square);
  return sum / static_cast<double>(std::max<std::size_t>(squares.size(), 1));
}

/// How much of an edge pair's energy counts: rises from 0 for parallel edges to 1 (Li et al. 2020, 4.2), by their
/// crossing, which is `full` where they no longer count as parallel.
struct Share {
  double value = 1, slope = 0, bend = 0;
};
Share share_of(double crossing, double full) {
  if (crossing >= full) return {};
  const double u = crossing / full;
  return {u * (2 - u), (2 - 2 * u) / full, -2 / (full * full)};
}

/// The order of neighbours.
bool comes_before(const Pair& a, const Pair& b) {
  return std::tie(a.kind, a.first, a.second) < std::tie(b.kind, b.first, b.second);
}

}  // namespace

SelfContact::SelfContact(const Cloth& cloth, double gap, double pressure)
    : SelfContact(cloth, std::vector<double>(index(cloth.fabric_count()), gap), pressure) {}

SelfContact::SelfContact(const Cloth& cloth, const std::vector<double>& gaps, double pressure)
    : cloth_(cloth),
      pressure_(pressure),
      widest_gap_(std::ranges::max(gaps)),
      gap_(of_vertices(cloth, gaps)),
      widest_(widest_gaps(cloth, widest_gap_)),
      area_of_edge_(edge_areas(cloth)),
      square_of_edge_(edge_squares(cloth)),
      slack_(share_of_edge * mean_length(square_of_edge_)) {}

void SelfContact::set_friction(const std::vector<double>& frictions) {
  friction_ = std::ranges::max(frictions) > 0 ? of_vertices(cloth_, frictions) : std::vector<double>{};
}

void SelfContact::leave_out(std::vector<bool> vertices) {
  left_out_ = std::move(vertices);
  swept_from_.resize(0);
  measured_at_.resize(0);
}

double SelfContact::gap_of(const Pair& pair) const {
  // The first vertex is of the one side, the last of the other.
  double gap = 0.5 * (gap_[index(pair.vertices.front())] + gap_[index(pair.vertices.back())]);
  for (const int v : pair.vertices) gap = std::min(gap, widest_[index(v)]);
  return gap;
}

double SelfContact::friction_of(const Pair& pair) const {
  return 0.5 * (friction_[index(pair.vertices.front())] + friction_[index(pair.vertices.back())]);
}

double SelfContact::area_of(const Pair& pair) const {
  // Each layer's corners carry a half of the contact against the other's faces; crossing edges add a little.
  return pair.kind == Pair::Kind::CornerTriangle
             ? cloth_.area_of_vertex[index(pair.first)] / 2
             : (area_of_edge_[index(pair.first)] + area_of_edge_[index(pair.second)]) / 8;
}

double SelfContact::parallel_of(const Pair& pair) const {
  if (pair.kind == Pair::Kind::CornerTriangle) return 0;
  return parallel * square_of_edge_[index(pair.first)] * square_of_edge_[index(pair.second)];
}

void SelfContact::gather(const Vector& from, const Vector& to) const {
  swept_from_ = from;
  swept_to_ = to;
  neighbours_ = neighbours(cloth_, from, to, soon * widest_gap_ / 2 + slack_);
  if (!left_out_.empty()) {
    std::erase_if(neighbours_, [&](const Pair& pair) {
      return std::ranges::all_of(pair.vertices, [&](int v) { return left_out_[index(v)]; });
    });
  }
  measured_at_.resize(0);
}

bool SelfContact::gathered(const Vector& q) const {
  if (swept_from_.size() == 0) return false;
  for (Eigen::Index i = 0; i < 3 * cloth_.vertex_count; ++i) {
    const auto [low, high] = std::minmax(swept_from_[i], swept_to_[i]);
    if (q[i] < low - slack_ || q[i] > high + slack_) return false;
  }
  return true;
}

std::vector<SelfContact::Touch> SelfContact::within(const Vector& q, double times_gap) const {
  if (!gathered(q)) gather(q, q);
  const double reach = times_gap * widest_gap_;
  std::vector<double> squared(neighbours_.size());
  parallel_for(neighbours_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Pair::Kind kind = neighbours_[i].kind;
      const Quad x = places(neighbours_[i], q);
      squared[i] = apart(kind, x) >= reach ? reach * reach : proximity(kind, x).squared;
    }
  });
  std::vector<Touch> touches;
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    if (squared[i] >= reach * reach) continue;
    const Pair& pair = neighbours_[i];
    const double gap = gap_of(pair);
    if (squared[i] >= times_gap * times_gap * gap * gap || squared[i] < coincident * coincident * gap * gap) continue;
    const Quad x = places(pair, q);
    touches.push_back({pair, x, proximity(pair.kind, x), gap, area_of(pair), parallel_of(pair)});
  }
  return touches;
}

const std::vector<SelfContact::Touch>& SelfContact::touches(const Vector& q) const {
  const Eigen::Index coordinates = 3 * cloth_.vertex_count;
  if (measured_at_.size() == coordinates && measured_at_ == q.head(coordinates)) return touches_;
  touches_ = within(q, 1);
  measured_at_ = q.head(coordinates);
  return touches_;
}

SelfContact::Barrier SelfContact::barrier(const Touch& touch) const {
  const double y = std::sqrt(touch.near.squared) / touch.gap;
  const double rest = 1 - y, log = std::log(y), scale = pressure_ * touch.area;
  return {-scale * touch.gap * rest * rest * log, scale * (2 * rest * log - rest * rest / y),
          scale / touch.gap * (-2 * log + 4 * rest / y + rest * rest / (y * y))};
}

double SelfContact::counted_share(const Touch& touch) const {
  return touch.pair.kind == Pair::Kind::CornerTriangle
             ? 1
             : share_of(edge_skew(touch.x, false).value, touch.parallel).value;
}

Vector12 SelfContact::gradient(const Touch& touch) const {
  const Barrier b = barrier(touch);
  const Vector12 by_distance = squared_gradient(touch.near, touch.x) / (2 * std::sqrt(touch.near.squared));
  if (touch.pair.kind == Pair::Kind::CornerTriangle) return b.slope * by_distance;
  const Skew skew = edge_skew(touch.x, false);
  const Share share = share_of(skew.value, touch.parallel);
  return share.value * b.slope * by_distance + share.slope * b.value * skew.gradient;
}

Matrix12 SelfContact::hessian(const Touch& touch, Curvature curvature) const {
  const Barrier b = barrier(touch);
  const double distance = std::sqrt(touch.near.squared);
  const Vector12 by_distance = squared_gradient(touch.near, touch.x) / (2 * distance);
  const Matrix12 square = by_distance * by_distance.transpose();
  const bool full = curvature == Curvature::Full;
  Matrix12 hessian = b.bend * square;
  if (full) hessian += b.slope / (2 * distance) * (squared_hessian(touch.near, touch.x) - 2 * square);
  if (touch.pair.kind == Pair::Kind::CornerTriangle) return hessian;
  const Skew skew = edge_skew(touch.x, full);
  const Share share = share_of(skew.value, touch.parallel);
  hessian *= share.value;
  if (full && share.value < 1) {
    const Matrix12 mixed = skew.gradient * by_distance.transpose();
    hessian += share.slope * b.slope * (mixed + mixed.transpose()) + share.slope * b.value * skew.hessian +
               share.bend * b.value * skew.gradient * skew.gradient.transpose();
  }
  return hessian;
}

double SelfContact::energy(const Vector& q, Vector* gradient) const {
  const std::vector<Touch>& touches = this->touches(q);
  double energy = 0;
  for (const Touch& touch : touches) {
    energy += counted_share(touch) * barrier(touch).value;
    if (gradient == nullptr) continue;
    const Vector12 derivative = this->gradient(touch);
    for (int k = 0; k < 4; ++k) {
      gradient->segment<3>(3 * touch.pair.vertices[static_cast<std::size_t>(k)]) += derivative.segment<3>(3 * k);
    }
  }
  for (const Hold& hold : holds_) {
    const Vector3 apart = hold.apart(q);
    energy += hold.grip.work(apart);
    if (gradient == nullptr) continue;
    const Vector3 pull = hold.grip.pull(apart);
    for (std::size_t k = 0; k < 4; ++k) gradient->segment<3>(3 * hold.pair.vertices[k]) += hold.weights[k] * pull;
  }
  return energy;
}

Vector3 SelfContact::Hold::apart(const Vector& q) const {
  Vector3 apart = Vector3::Zero();
  for (std::size_t k = 0; k < 4; ++k) apart += weights[k] * q.segment<3>(3 * pair.vertices[k]);
  return apart;
}

double SelfContact::friction_energy(const Vector& q) const {
  double energy = 0;
  for (const Hold& hold : holds_) energy += hold.grip.work(hold.apart(q));
  return energy;
}

// What touches on keeps its pull, what newly touches begins with none, and what has come apart lets go.
void SelfContact::accept(const Vector& q) {
  if (friction_.empty()) return;
  std::vector<Hold> holds;
  auto earlier = holds_.cbegin();
  for (const Touch& touch : touches(q)) {
    while (earlier != holds_.cend() && comes_before(earlier->pair, touch.pair)) ++earlier;
    const bool held = earlier != holds_.cend() && !comes_before(touch.pair, earlier->pair);
    Hold hold{touch.pair, touch.near.weights, {}};
    const Vector3 apart = hold.apart(q);
    hold.grip = grip_on(held ? earlier->grip.pull(earlier->apart(q)) : Vector3::Zero(), apart, apart.normalized(),
                        friction_of(touch.pair) * counted_share(touch) * -barrier(touch).slope);
    holds.push_back(std::move(hold));
  }
  holds_ = std::move(holds);
}

void SelfContact::add_hessian(const Vector& q, Curvature curvature, SparseMatrix& matrix) const {
  const std::vector<Touch>& touches = this->touches(q);
  std::vector<Matrix12> blocks(touches.size());
  parallel_for(touches.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) blocks[i] = hessian(touches[i], curvature);
  });
  for (std::size_t i = 0; i < touches.size(); ++i) {
    for (int row = 0; row < 12; ++row) {
      for (int column = 0; column <= row; ++column) {
        matrix.add(3 * touches[i].pair.vertices[index(row / 3)] + row % 3,
                   3 * touches[i].pair.vertices[index(column / 3)] + column % 3, blocks[i](row, column));
      }
    }
  }
  for (const Hold& hold : holds_) {
    const Matrix3 stiffness = hold.grip.stiffness(hold.apart(q));
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t l = 0; l <= k; ++l) {
        const double share = hold.weights[k] * hold.weights[l];
        if (share == 0) continue;
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < (k == l ? i + 1 : 3); ++j) {
            matrix.add(3 * hold.pair.vertices[k] + i, 3 * hold.pair.vertices[l] + j, share * stiffness(i, j));
          }
        }
      }
    }
  }
}

double SelfContact::free_fraction(const Vector& q, const Vector& step) const {
  const Vector to = q + step;
  if (!gathered(q) || !gathered(to)) gather(q, to);
  std::vector<double> fractions(neighbours_.size());
  parallel_for(neighbours_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fractions[i] = toile::free_fraction(neighbours_[i], q, step, 1);
  });
  return fractions.empty() ? 1 : *std::min_element(fractions.begin(), fractions.end());
}

bool SelfContact::fits(const Vector& q, const SparseMatrix& matrix) const {
  const auto has_place = [&](const Pair& pair) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!matrix.has(3 * pair.vertices[i], 3 * pair.vertices[j])) return false;
      }
    }
    return true;
  };
  return std::ranges::all_of(touches(q), has_place, &Touch::pair) &&
         std::ranges::all_of(holds_, has_place, &Hold::pair);
}

std::vector<std::vector<int>> SelfContact::couplings(const Vector& q) const {
  std::vector<std::vector<int>> couplings;
  const auto couple = [&](const Pair& pair) {
    std::vector<int> unknowns;
    for (const int v : pair.vertices) {
      for (int k = 0; k < 3; ++k) unknowns.push_back(3 * v + k);
    }
    couplings.push_back(std::move(unknowns));
  };
  for (const Touch& touch : within(q, soon)) couple(touch.pair);
  for (const Hold& hold : holds_) couple(hold.pair);
  return couplings;
}

}  // namespace toile
