#include "runtime/develop/pattern_step.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/develop/flips.hpp"
#include "runtime/develop/plane_unknowns.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr double match_stiffness = 1e5;  // of a match over that of the sheet
constexpr double smoothing = 0.15;       // of the square root of a piece's area: finer waves cost more
constexpr int most_rounds = 60;          // of conjugate gradients
constexpr double good_enough = 1e-3;     // of what they start from
constexpr int most_matchings = 20;
constexpr double matched = 1e-5;  // of a side's length
constexpr double share_of_slip = 0.3;
constexpr double most_of_a_step = 0.5;  // of the way to where a triangle has a tenth of its area left

Vec2 at(const Vector& q, int point) {
  return {q[2 * point], q[2 * point + 1]};
}

Vector flat_vector(const std::vector<Vec2>& points) {
  Vector q(2 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    q[2 * static_cast<Eigen::Index>(i)] = points[i].x;
    q[2 * static_cast<Eigen::Index>(i) + 1] = points[i].y;
  }
  return q;
}

std::vector<Vec2> plane_points(const Vector& q) {
  std::vector<Vec2> points;
  for (int i = 0; i < q.size() / 2; ++i) points.push_back(at(q, i));
  return points;
}

/// What a change of the pattern costs: that of a plain sheet, e_u^2 + e_v^2 + e_uv^2 / 2 an area, whose matched sides
/// stay as long as each other, for the change as it was before it was smoothed. With K the sheet's stiffness, M its
/// mass and L the smoothing length, smoothing solves (K + M / L^2) smooth = M / L^2 rough.
class Sheet {
 public:
  Sheet(const FlatteningInput& plane, const Vector& q)
      : plane_(plane), matrix_(free_plane_unknowns(plane), plane_elements(plane)) {
    stiff_.analyse(matrix_);
    smooth_.analyse(matrix_);
    for (const LengthMatch& match : plane.matches) places_.push_back(matrix_.places(plane_unknowns(match)));
    stand(q);
  }

  /// Takes the pattern for the sheet at rest.
  void stand(const Vector& q) {
    matrix_.set_zero();
    mass_ = Vector::Zero(q.size());
    double area = 0;
    for (const std::array<int, 3>& triangle : plane_.triangles) {
      const MembraneShape shape = membrane_shape({at(q, triangle[0]), at(q, triangle[1]), at(q, triangle[2])});
      add_triangle(triangle, shape);
      area += shape.area;
    }
    add_springs(q);
    sound_ = stiff_.factorise(matrix_);
    const double length = smoothing * std::sqrt(area / std::max<double>(1, static_cast<double>(plane_.grain.size())));
    mass_ /= length * length;
    matrix_.add_diagonal({mass_.data(), static_cast<std::size_t>(mass_.size())}, 1);
    sound_ = sound_ && smooth_.factorise(matrix_);
  }

  bool sound() const { return sound_; }
  /// The change that costs a load its least.
  Vector change(const Vector& load) const {
    const Vector rough = stiff_.solve_free(matrix_, mass_.cwiseProduct(smooth_.solve_free(matrix_, load)));
    return smooth_.solve_free(matrix_, mass_.cwiseProduct(rough));
  }
  /// Where the springs between matched sides that are not equally long pull the sheet.
  Vector sprung() const { return stiff_.solve_free(matrix_, spring_load_); }

 private:
  void add_triangle(const std::array<int, 3>& triangle, const MembraneShape& shape) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const int a = 2 * triangle[i], b = 2 * triangle[j];
        const double uu = shape.du[i] * shape.du[j], vv = shape.dv[i] * shape.dv[j];
        const std::array<std::array<double, 2>, 2> block{
            {{uu + vv / 2, shape.dv[i] * shape.du[j] / 2}, {shape.du[i] * shape.dv[j] / 2, vv + uu / 2}}};
        for (int k = 0; k < 2; ++k) {
          for (int l = 0; l < 2; ++l) {
            if (a + k >= b + l) matrix_.add(a + k, b + l, shape.area * block[index(k)][index(l)]);
          }
        }
      }
      mass_.segment<2>(2 * triangle[i]).array() += shape.area / 3;
    }
  }

  void add_springs(const Vector& q) {
    spring_load_ = Vector::Zero(q.size());
    for (std::size_t m = 0; m < plane_.matches.size(); ++m) {
      const LengthMatch& match = plane_.matches[m];
      const std::array<int, 4> points = points_of(match);
      const Mismatch found = mismatch(match, {at(q, points[0]), at(q, points[1]), at(q, points[2]), at(q, points[3])});
      const double k = match_stiffness / match.length;
      add_match(match, k * found.gradient * found.gradient.transpose(), places_[m], matrix_);
      for (int i = 0; i < 4; ++i) {
        spring_load_.segment<2>(2 * points[static_cast<std::size_t>(i)]) -=
            k * found.value * found.gradient.segment<2>(2 * i);
      }
    }
  }

  const FlatteningInput& plane_;
  SparseMatrix matrix_;
  Cholesky stiff_, smooth_;
  std::vector<std::vector<std::int32_t>> places_;
  Vector spring_load_, mass_;
  bool sound_ = false;
};

/// The misses as a linear function of the pattern's change, and back. A vertex misses the form's surface by the whole
/// of its distance, and its own place on the form by a share of what it lies aside from there, lest less cloth be
/// nearer.
class Sensitivity {
 public:
  Sensitivity(const FlatteningInput& plane, const Cloth& cloth, const RestState& rest, const FormDistance& misses)
      : plane_(plane), rest_(rest), misses_(misses), couplings_(rest.elastic.pattern_couplings(cloth, rest.q)) {
    for (std::size_t t = 0; t < couplings_.size(); ++t)
      add_weight(membrane_shape(cloth.triangles[t].uv), couplings_[t]);
  }

  Vector misses_of(const Vector& change) const {
    Vector load = Vector::Zero(rest_.q.size());
    for (std::size_t t = 0; t < couplings_.size(); ++t) {
      Eigen::Matrix<double, 6, 1> corners;
      for (int i = 0; i < 3; ++i) corners.segment<2>(2 * i) = change.segment<2>(2 * point(t, i));
      const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 21, 1> forces = couplings_[t].by_corners * corners;
      for (std::size_t k = 0; k < couplings_[t].unknowns.size(); ++k) {
        load[couplings_[t].unknowns[k]] -= forces[static_cast<Eigen::Index>(k)];
      }
    }
    const Vector motion = rest_.give(load);
    Vector found(3 * vertices());
    for (int v = 0; v < vertices(); ++v) found.segment<3>(3 * v) = counted(v, motion.segment<3>(3 * v));
    return found;
  }

  Vector back(const Vector& misses) const {
    Vector load = Vector::Zero(rest_.q.size());
    for (int v = 0; v < vertices(); ++v) load.segment<3>(3 * v) = counted(v, misses.segment<3>(3 * v));
    const Vector motion = rest_.give(load);
    Vector change = Vector::Zero(2 * static_cast<Eigen::Index>(plane_.start.size()));
    for (std::size_t t = 0; t < couplings_.size(); ++t) {
      Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 21, 1> moved(couplings_[t].by_corners.rows());
      for (std::size_t k = 0; k < couplings_[t].unknowns.size(); ++k) {
        moved[static_cast<Eigen::Index>(k)] = motion[couplings_[t].unknowns[k]];
      }
      const Eigen::Matrix<double, 6, 1> corners = couplings_[t].by_corners.transpose() * moved;
      for (int i = 0; i < 3; ++i) change.segment<2>(2 * point(t, i)) -= corners.segment<2>(2 * i);
    }
    return change;
  }

 private:
  int vertices() const { return static_cast<int>(misses_.across.size()); }
  Vector3 counted(int vertex, const Vector3& way) const {
    const Vector3 across = to_eigen(misses_.across[index(vertex)]);
    const Vector3 off = way.dot(across) * across;
    return off + share_of_slip * (way - off);
  }
  int point(std::size_t triangle, int corner) const { return plane_.triangles[triangle][index(corner)]; }

  /// A third of the triangle's weight hangs on each of its corners: its unknowns 2, 5 and 8.
  void add_weight(const MembraneShape& shape, PatternCoupling& coupling) const {
    for (int corner = 0; corner < 3; ++corner) {
      for (std::size_t j = 0; j < 3; ++j) {
        const double third = rest_.weight * shape.area / 3;
        coupling.by_corners(3 * corner + 2, 2 * static_cast<Eigen::Index>(j)) += third * shape.du[j];
        coupling.by_corners(3 * corner + 2, 2 * static_cast<Eigen::Index>(j) + 1) += third * shape.dv[j];
      }
    }
  }

  const FlatteningInput& plane_;
  const RestState& rest_;
  const FormDistance& misses_;
  std::vector<PatternCoupling> couplings_;
};

Vector all_misses(const FormDistance& found) {
  Vector missed(3 * static_cast<Eigen::Index>(found.across.size()));
  for (std::size_t v = 0; v < found.across.size(); ++v) {
    const Vector3 across = to_eigen(found.across[v]), slip = to_eigen(found.slips[v]);
    missed.segment<3>(3 * static_cast<Eigen::Index>(v)) =
        found.of_vertex[v] * across + share_of_slip * (slip - slip.dot(across) * across);
  }
  return missed;
}

/// Of each coordinate: its vertex's share of the cloth.
Vector weights_of(const Cloth& cloth) {
  Vector weights(3 * static_cast<Eigen::Index>(cloth.area_of_vertex.size()));
  for (std::size_t v = 0; v < cloth.area_of_vertex.size(); ++v) {
    weights.segment<3>(3 * static_cast<Eigen::Index>(v)).setConstant(cloth.area_of_vertex[v] / cloth.area);
  }
  return weights;
}

double weighted_square(const Vector& misses, const Vector& weights) {
  return misses.dot(weights.cwiseProduct(misses));
}

}  // namespace

double missed(const Cloth& cloth, const FormDistance& misses) {
  return std::sqrt(weighted_square(all_misses(misses), weights_of(cloth)));
}

PatternStep pattern_step(const FlatteningInput& plane, const std::vector<Vec2>& uv, const Cloth& cloth,
                         const RestState& rest, const FormDistance& misses, double caution) {
  PatternStep step;
  const Sheet sheet(plane, flat_vector(uv));
  if (!sheet.sound()) return step;
  const Sensitivity sensitivity(plane, cloth, rest, misses);
  const Vector missed = all_misses(misses), weights = weights_of(cloth);
  // Conjugate gradients for (J^T W J + weight P) du = -J^T W m, with P, what the change costs, as preconditioner.
  Vector left = -sensitivity.back(weights.cwiseProduct(missed));
  Vector shaped = sheet.change(left);
  double slope = left.dot(shaped);
  if (!(slope > 0)) return step;
  const double first_slope = slope;
  const double weight = caution * weighted_square(sensitivity.misses_of(shaped), weights) / slope;
  Vector change = Vector::Zero(left.size()), direction = shaped, cost = left;  // cost = P direction
  for (int round = 0; round < most_rounds && slope > good_enough * good_enough * first_slope; ++round) {
    const Vector product = sensitivity.back(weights.cwiseProduct(sensitivity.misses_of(direction))) + weight * cost;
    const double curvature = direction.dot(product);
    if (!(curvature > 0)) break;
    change += slope / curvature * direction;
    left -= slope / curvature * product;
    shaped = sheet.change(left);
    const double next = left.dot(shaped);
    direction = shaped + next / slope * direction;
    cost = left + next / slope * cost;
    slope = next;
  }
  step.left = std::sqrt(weighted_square(missed + sensitivity.misses_of(change), weights) /
                        std::max(weighted_square(missed, weights), 1e-300));
  step.change = plane_points(change);
  return step;
}

std::vector<Vec2> changed_pattern(const FlatteningInput& plane, const std::vector<Vec2>& uv,
                                  const std::vector<Vec2>& change) {
  Vector q = flat_vector(uv);
  const auto go = [&](const Vector& way) {
    double longest = 1;
    for (const std::array<int, 3>& triangle : plane.triangles) {
      const PlaneCorners corners{at(q, triangle[0]), at(q, triangle[1]), at(q, triangle[2])};
      const PlaneCorners moves{at(way, triangle[0]), at(way, triangle[1]), at(way, triangle[2])};
      longest = std::min(longest, most_of_a_step * step_before_flip(corners, moves));
    }
    q += longest * way;
  };
  go(flat_vector(change));
  Sheet sheet(plane, q);
  for (int round = 0; round < most_matchings && sheet.sound(); ++round) {
    double largest = 0;
    for (const LengthMatch& match : plane.matches) {
      const std::array<int, 4> p = points_of(match);
      largest =
          std::max(largest, std::abs(mismatch(match, {at(q, p[0]), at(q, p[1]), at(q, p[2]), at(q, p[3])}).value) /
                                match.length);
    }
    if (largest < matched) break;
    go(sheet.sprung());
    sheet.stand(q);
  }
  return plane_points(q);
}

}  // namespace toile
