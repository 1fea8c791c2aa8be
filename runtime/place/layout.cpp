#include "runtime/place/layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "runtime/mesh/vector.hpp"
#include "runtime/place/relax.hpp"

namespace toile {
namespace {

constexpr int most_landmarks = 32;
constexpr int laying_passes = 30;
using Point4 = Eigen::Vector4d;

/// Squared distances from landmarks to all members, and which members the landmarks are.
struct Separations {
  std::vector<int> landmarks;
  Eigen::MatrixXd squared;  // (landmark, member)
};

// Each landmark as far as can be from those before.
Separations measure(const RestMesh& rest, const std::vector<int>& members) {
  const int count = std::min(most_landmarks, static_cast<int>(members.size()));
  const int n = static_cast<int>(members.size());
  Separations result{{}, Eigen::MatrixXd(count, n)};
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(n, 1e300);
  Eigen::Index next = 0;
  for (int l = 0; l < count; ++l) {
    result.landmarks.push_back(static_cast<int>(next));
    const std::vector<double> distance = rest.distance_from({members[next]});
    for (int i = 0; i < n; ++i) result.squared(l, i) = distance[members[i]] * distance[members[i]];
    nearest = nearest.cwiseMin(result.squared.row(l).transpose());
    nearest.maxCoeff(&next);
  }
  return result;
}

struct Embedding {
  std::vector<Point4> points;  // one a member
  Point4 variances;            // descending
};

Embedding embed(const Separations& separations) {
  const int n = static_cast<int>(separations.landmarks.size());
  Eigen::MatrixXd squared(n, n);
  for (int j = 0; j < n; ++j) squared.col(j) = separations.squared.col(separations.landmarks[j]);
  squared = (0.5 * (squared + squared.transpose())).eval();
  const Eigen::VectorXd mean = squared.rowwise().mean();
  Eigen::MatrixXd gram = -0.5 * squared;
  gram.colwise() += 0.5 * mean;
  gram.rowwise() += 0.5 * mean.transpose();
  gram.array() -= 0.5 * mean.mean();
  const Spectrum whole = spectrum(gram);

  Embedding result{{}, Point4::Zero()};
  Eigen::MatrixXd axes = Eigen::MatrixXd::Zero(n, 4);
  for (int k = 0; k < std::min(4, n); ++k) {
    const double value = whole.values(n - 1 - k);
    if (!(value > 1e-12)) break;
    Eigen::VectorXd vector = whole.vectors.col(n - 1 - k);
    Eigen::Index largest = 0;
    vector.cwiseAbs().maxCoeff(&largest);
    if (vector(largest) < 0) vector = -vector;
    result.variances(k) = value;
    axes.col(k) = vector / std::sqrt(value);
  }
  for (Eigen::Index i = 0; i < separations.squared.cols(); ++i) {
    result.points.emplace_back(0.5 * axes.transpose() * (mean - separations.squared.col(i)));
  }
  return result;
}

// A surface that closes upon itself: angles round the circle it makes in two of the dimensions.
struct Circle {
  double radius = 0;
  std::vector<double> angle;
};

using Plane = Eigen::Matrix<double, 2, 3>;  // two orthonormal rows

Plane plane_across(const Eigen::Vector3d& axis) {
  const Eigen::Vector3d u = axis.unitOrthogonal();
  Plane plane;
  plane << u.transpose(), axis.cross(u).transpose();
  return plane;
}

// Deviation of the points' distance from the origin within a plane, over its mean.
double unevenness(const Plane& plane, const std::vector<Point4>& points) {
  double sum = 0, sum2 = 0;
  for (const Point4& p : points) {
    const double radius2 = (plane * p.head<3>()).squaredNorm();
    sum += std::sqrt(radius2);
    sum2 += radius2;
  }
  const auto n = static_cast<double>(points.size());
  return std::sqrt(std::max(0.0, sum2 * n / (sum * sum) - 1));
}

std::optional<Circle> circle_in(const Plane& plane, const std::vector<Point4>& points) {
  constexpr double most_unevenness = 0.15;
  constexpr int sectors = 12;
  if (!(unevenness(plane, points) < most_unevenness)) return std::nullopt;
  Circle circle;
  std::array<bool, sectors> met{};
  for (const Point4& p : points) {
    const Eigen::Vector2d q = plane * p.head<3>();
    // Arcs of a circle are longer than its chords: scaling embeds them with a radius too large by the root of two.
    circle.radius += q.norm() / std::numbers::sqrt2 / static_cast<double>(points.size());
    circle.angle.push_back(std::atan2(q(1), q(0)));
    met[std::min(sectors - 1, static_cast<int>((circle.angle.back() / std::numbers::pi + 1) / 2 * sectors))] = true;
  }
  if (!std::all_of(met.begin(), met.end(), [](bool m) { return m; })) return std::nullopt;
  return circle;
}

// In the plane of the first two dimensions if there is one, else in the evenest plane of three.
std::optional<Circle> find_circle(const std::vector<Point4>& points) {
  const Eigen::Vector3d third = Eigen::Vector3d::UnitZ();
  if (std::optional<Circle> circle = circle_in(plane_across(third), points)) return circle;
  Eigen::Vector3d best = third;
  double least = unevenness(plane_across(third), points);
  const auto consider = [&](const Eigen::Vector3d& axis) {
    const double uneven = unevenness(plane_across(axis), points);
    if (uneven < least) {
      least = uneven;
      best = axis;
    }
  };
  constexpr int directions = 100;
  for (int i = 0; i < directions; ++i) {  // spread over a hemisphere along the golden spiral
    const double z = (i + 0.5) / directions, angle = 2.399963 * i, r = std::sqrt(1 - z * z);
    consider({r * std::cos(angle), r * std::sin(angle), z});
  }
  constexpr int refinements = 12;
  for (int i = 0; i < refinements; ++i) {
    const Eigen::Vector3d u = 0.1 * std::pow(0.7, i) * best.unitOrthogonal(), v = best.cross(u);
    const std::array<Eigen::Vector3d, 4> about{best + u, best + v, best - u, best - v};
    for (const Eigen::Vector3d& axis : about) consider(axis.normalized());
  }
  return circle_in(plane_across(best), points);
}

// What is left of the distances when the way round the circle is taken off.
Separations across(const Circle& circle, const Separations& separations) {
  Separations result = separations;
  for (Eigen::Index l = 0; l < result.squared.rows(); ++l) {
    const double from = circle.angle[separations.landmarks[l]];
    for (Eigen::Index i = 0; i < result.squared.cols(); ++i) {
      const double arc = circle.radius * std::remainder(circle.angle[i] - from, 2 * std::numbers::pi);
      result.squared(l, i) = std::max(0.0, result.squared(l, i) - arc * arc);
    }
  }
  return result;
}

// A ring with its axis upright, whose cross-section is another ring or else flat.
std::vector<Vec3> ring(const Circle& circle, const Embedding& section) {
  std::vector<Vec3> points;
  const std::optional<Circle> tube = circle_in(plane_across(Eigen::Vector3d::UnitZ()), section.points);
  const bool is_bent = section.variances(1) > 0.1 * section.variances(0);  // less is the error of the distances
  for (std::size_t i = 0; i < circle.angle.size(); ++i) {
    const double out = tube ? tube->radius * std::cos(tube->angle[i]) : is_bent ? section.points[i](1) : 0;
    const double up = tube ? tube->radius * std::sin(tube->angle[i]) : section.points[i](0);
    const double radius = std::max(circle.radius, tube ? 1.1 * tube->radius : 0) + out;
    points.push_back({radius * std::cos(circle.angle[i]), radius * std::sin(circle.angle[i]), up});
  }
  return points;
}

// The largest cosine between a direction and the points'.
double nearness(const Point4& direction, const std::vector<Point4>& points) {
  double nearest = -1;
  for (const Point4& p : points) nearest = std::max(nearest, direction.dot(p) / std::max(p.norm(), 1e-12));
  return nearest;
}

// The direction that keeps farthest from all points, among the axes and many spread over the sphere.
Point4 emptiest_direction(const std::vector<Point4>& points) {
  Point4 best = Point4::UnitX();
  double least = 2;
  const auto consider = [&](const Point4& direction) {
    const double near = nearness(direction, points);
    if (near < least - 1e-9) {
      least = near;
      best = direction;
    }
  };
  for (int k = 0; k < 4; ++k) {
    consider(Point4::Unit(k));
    consider(-Point4::Unit(k));
  }
  std::uint32_t state = 1;
  const auto next = [&] {
    state = state * 1664525U + 1013904223U;
    return static_cast<double>(state >> 8) / (1 << 23) - 1;
  };
  double reach = 1;
  for (int i = 0; i < 400; ++i) {
    const Point4 shift(next(), next(), next(), next());
    if (i >= 200) reach *= 0.98;  // at last, about the best
    const Point4 direction = i < 200 ? shift : Point4(best + 0.5 * reach * shift);
    if (direction.norm() > 0.1) consider(direction.normalized());
  }
  return best;
}

// Stereographic projection of points near a sphere about the origin.
std::vector<Vec3> project(const std::vector<Point4>& points) {
  const Point4 pole = emptiest_direction(points);
  Point4 mirror = pole - Point4::UnitW();  // the reflection that takes the pole to the last axis
  const double length2 = mirror.squaredNorm();
  std::vector<Vec3> result;
  for (const Point4& p : points) {
    const Point4 q = length2 > 1e-12 ? Point4(p - 2 * mirror.dot(p) / length2 * mirror) : p;
    const double radius = std::max(p.norm(), 1e-12);
    const double scale = 1 / std::max(1 - q(3) / radius, 0.05);
    result.push_back({scale * q(0), scale * q(1), scale * q(2)});
  }
  return result;
}

void fit_size(const RestMesh& rest, const std::vector<bool>& inside, std::vector<Vec3>& positions) {
  double now = 0, wanted = 0;
  for (std::size_t e = 0; e < rest.edge_length().size(); ++e) {
    const auto [a, b] = rest.cloth().edges[e].vertices;
    if (!inside[a]) continue;
    now += distance(positions[a], positions[b]);
    wanted += rest.edge_length()[e];
  }
  if (!(now > 0)) return;
  for (std::size_t v = 0; v < inside.size(); ++v) {
    if (inside[v]) positions[v] = wanted / now * positions[v];
  }
}

void centre(const std::vector<int>& members, std::vector<Vec3>& positions) {
  Vec3 sum;
  for (const int v : members) sum += positions[v];
  for (const int v : members) positions[v] = positions[v] - sum / static_cast<double>(members.size());
}

void turn_right_side_out(const RestMesh& rest, const std::vector<int>& members, const std::vector<bool>& inside,
                         std::vector<Vec3>& positions) {
  double outward = 0;
  for (const ClothTriangle& t : rest.cloth().triangles) {
    if (!inside[t.vertices[0]]) continue;
    outward += dot(positions[t.vertices[0]], cross(positions[t.vertices[1]], positions[t.vertices[2]]));
  }
  if (outward >= 0) return;
  for (const int v : members) positions[v].x = -positions[v].x;
}

std::vector<Vec3> arrange(const Separations& separations) {
  const Embedding embedding = embed(separations);
  if (const std::optional<Circle> circle = find_circle(embedding.points)) {
    return ring(*circle, embed(across(*circle, separations)));
  }
  if (embedding.variances(3) > 0.4 * embedding.variances(2)) return project(embedding.points);
  std::vector<Vec3> points;
  for (const Point4& p : embedding.points) points.push_back({p(0), p(1), p(2)});
  return points;
}

}  // namespace

void lay_out(const RestMesh& rest, const std::vector<int>& members, std::vector<Vec3>& positions) {
  const std::vector<Vec3> points = arrange(measure(rest, members));
  std::vector<bool> inside(positions.size(), false);
  for (std::size_t i = 0; i < members.size(); ++i) {
    inside[members[i]] = true;
    positions[members[i]] = points[i];
  }
  centre(members, positions);
  fit_size(rest, inside, positions);
  relax(rest, inside, laying_passes, nullptr, 0, positions);
  centre(members, positions);
  turn_right_side_out(rest, members, inside, positions);
}

}  // namespace toile
