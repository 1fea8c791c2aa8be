#include "runtime/develop/conformal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/develop/flattening.hpp"
#include "runtime/mesh/index.hpp"
#include "runtime/solve/sparse.hpp"

namespace toile {
namespace {

constexpr double cells_a_triangle = 0.5;
constexpr double off_triangle = 1e-9;       // how far outside of a triangle, in its own coordinates, still is on it
constexpr double least_twice_area = 1e-14;  // [m2] of a triangle that counts

/// Shares of the corners in a place.
std::array<double, 3> shares(const std::array<Vec2, 3>& c, Vec2 p) {
  const double twice = cross(c[1] - c[0], c[2] - c[0]);
  const double second = cross(p - c[0], c[2] - c[0]) / twice, third = cross(c[1] - c[0], p - c[0]) / twice;
  return {1 - second - third, second, third};
}

int farthest_from(const std::vector<Vec3>& points, const std::vector<int>& among, Vec3 from) {
  return *std::max_element(among.begin(), among.end(), [&](int a, int b) {
    return distance(points[index(a)], from) < distance(points[index(b)], from);
  });
}

}  // namespace

ConformalMap::ConformalMap(Patch patch, const Seat& seat, std::string& error)
    : patch_(std::move(patch)), tree_({patch_.points, patch_.triangles}) {
  if (!lay_out()) {
    error = "the conformal map of this part of the body could not be found";
    return;
  }
  this->seat(seat);
  for (std::size_t t = 0; t < patch_.triangles.size(); ++t) {
    const std::array<Vec2, 3> flat = corners(t);
    const auto space = [&](std::size_t i) { return patch_.points[index(patch_.triangles[t][i])]; };
    const bool counts = norm(cross(space(1) - space(0), space(2) - space(0))) > least_twice_area;
    if (!counts || cross(flat[1] - flat[0], flat[2] - flat[0]) > 0) continue;
    const Vec3 at = space(0);
    error = fmt::format("the conformal map folds over at ({:.1f} cm, {:.1f} cm, {:.1f} cm): give it less reach",
                        100 * at.x, 100 * at.y, 100 * at.z);
    return;
  }
  sort_triangles();
}

std::array<Vec2, 3> ConformalMap::corners(std::size_t triangle) const {
  const auto& t = patch_.triangles[triangle];
  return {places_[index(t[0])], places_[index(t[1])], places_[index(t[2])]};
}

/// Least is Dirichlet's integral of both coordinates less the area that they cover; two points of the rim, far from
/// each other, are held.
bool ConformalMap::lay_out() {
  const int first = farthest_from(patch_.points, patch_.boundary, patch_.points[index(patch_.boundary.front())]);
  const int second = farthest_from(patch_.points, patch_.boundary, patch_.points[index(first)]);
  const std::size_t unknowns = 2 * patch_.points.size();
  std::vector<int> reduced(unknowns, 0);
  for (const int held : {first, second}) reduced[index(2 * held)] = reduced[index(2 * held + 1)] = -1;
  int rows = 0;
  for (int& row : reduced) row = row < 0 ? -1 : rows++;
  std::vector<std::vector<int>> elements;
  for (const auto& t : patch_.triangles) {
    elements.push_back({2 * t[0], 2 * t[0] + 1, 2 * t[1], 2 * t[1] + 1, 2 * t[2], 2 * t[2] + 1});
  }
  SparseMatrix matrix(reduced, elements);
  Vector places = Vector::Zero(static_cast<Eigen::Index>(unknowns));
  places[2 * second] = distance(patch_.points[index(first)], patch_.points[index(second)]);
  Vector slope = Vector::Zero(places.size());
  for (const auto& corner : patch_.triangles) {
    const auto flat = target_triangle(
        {patch_.points[index(corner[0])], patch_.points[index(corner[1])], patch_.points[index(corner[2])]});
    if (!flat || !(2 * flat->area > least_twice_area)) continue;
    const MembraneShape shape =
        membrane_shape({Vec2{0, 0}, Vec2{flat->sides(0, 0), 0}, Vec2{flat->sides(0, 1), flat->sides(1, 1)}});
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const double along = shape.area * (shape.du[i] * shape.du[j] + shape.dv[i] * shape.dv[j]);
        const double around = shape.area * (shape.du[i] * shape.dv[j] - shape.dv[i] * shape.du[j]);
        const int a = 2 * corner[i], b = 2 * corner[j];
        if (a >= b) {
          matrix.add(a, b, along);
          matrix.add(a + 1, b + 1, along);
          matrix.add(a + 1, b, around);
          if (a > b) matrix.add(a, b + 1, -around);
        }
        slope[a] += along * places[b] - around * places[b + 1];
        slope[a + 1] += along * places[b + 1] + around * places[b];
      }
    }
  }
  Cholesky cholesky;
  cholesky.analyse(matrix);
  if (!cholesky.factorise(matrix)) return false;
  places -= cholesky.solve_free(matrix, slope);
  for (std::size_t i = 0; i < patch_.points.size(); ++i) {
    places_.push_back({places[static_cast<Eigen::Index>(2 * i)], places[static_cast<Eigen::Index>(2 * i + 1)]});
  }
  return places.allFinite();
}

/// Turned, scaled and shifted; the scale is that about the origin, a few triangles wide.
void ConformalMap::seat(const Seat& seat) {
  const TriangleTree::Hit hit = tree_.nearest(seat.origin, 1e9);
  const auto& corner = patch_.triangles[index(hit.triangle)];
  const auto space = [&](std::size_t i) { return patch_.points[index(corner[i])]; };
  const auto flat = corners(index(hit.triangle));
  // The plane's directions as functions of those in space, in the nearest triangle.
  const Vec3 side = space(1) - space(0), normal = normalized(cross(side, space(2) - space(0)));
  const Vec3 x = normalized(side), y = cross(normal, x);
  const auto local = [&](Vec3 p) { return Vec2{dot(p - space(0), x), dot(p - space(0), y)}; };
  const std::array<Vec2, 3> own{local(space(0)), local(space(1)), local(space(2))};
  const auto image = [&](Vec2 p) {
    const auto share = shares(own, p);
    return share[0] * flat[0] + share[1] * flat[1] + share[2] * flat[2];
  };
  const Vec2 origin = local(hit.where.point), centre = image(origin);
  Vec2 up{dot(seat.up, x), dot(seat.up, y)};
  up = norm(up) > 1e-9 ? up / norm(up) : Vec2{0, 1};
  const Vec2 upwards = image(origin + up) - centre;
  const double angle = std::atan2(upwards.x, upwards.y);
  const double stretched = std::sqrt(std::abs(cross(flat[1] - flat[0], flat[2] - flat[0])) /
                                     std::max(cross(own[1] - own[0], own[2] - own[0]), least_twice_area));
  const Vec2 along = direction(angle) / std::max(stretched, 1e-12);
  for (Vec2& place : places_) {
    const Vec2 way = place - centre;
    place = way.x * along + way.y * perpendicular(along);
  }
}

void ConformalMap::sort_triangles() {
  Vec2 high{-1e300, -1e300};
  low_ = {1e300, 1e300};
  for (const Vec2 p : places_) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Vec2 span = high - low_;
  cell_ = std::max(std::sqrt(span.x * span.y / (cells_a_triangle * static_cast<double>(patch_.triangles.size()))),
                   1e-6 * std::max(span.x, span.y));
  columns_ = static_cast<int>(span.x / cell_) + 1;
  rows_ = static_cast<int>(span.y / cell_) + 1;
  cells_.resize(index(columns_) * index(rows_));
  for (std::size_t t = 0; t < patch_.triangles.size(); ++t) {
    const auto c = corners(t);
    const auto cell = [&](double value, double from) { return static_cast<int>((value - from) / cell_); };
    const auto [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
    const auto [bottom, top] = std::minmax({c[0].y, c[1].y, c[2].y});
    for (int row = cell(bottom, low_.y); row <= cell(top, low_.y); ++row) {
      for (int column = cell(left, low_.x); column <= cell(right, low_.x); ++column) {
        cells_[index(row) * index(columns_) + index(column)].push_back(static_cast<int>(t));
      }
    }
  }
}

std::vector<Vec3> ConformalMap::at(Vec2 place) const {
  std::vector<Vec3> found;
  const double column = (place.x - low_.x) / cell_, row = (place.y - low_.y) / cell_;
  if (!(column >= 0 && row >= 0 && column < columns_ && row < rows_)) return found;
  for (const int t : cells_[static_cast<std::size_t>(row) * index(columns_) + static_cast<std::size_t>(column)]) {
    const auto share = shares(corners(index(t)), place);
    if (std::min({share[0], share[1], share[2]}) < -off_triangle) continue;
    Vec3 point;
    for (std::size_t i = 0; i < 3; ++i) point += share[i] * patch_.points[index(patch_.triangles[index(t)][i])];
    found.push_back(point);
  }
  return found;
}

std::optional<Vec2> ConformalMap::place_of(Vec3 p, double reach) const {
  const TriangleTree::Hit hit = tree_.nearest(p, reach);
  if (hit.triangle < 0 || cells_.empty()) return std::nullopt;
  const auto& t = patch_.triangles[index(hit.triangle)];
  const Vec3 a = patch_.points[index(t[0])], ab = patch_.points[index(t[1])] - a, ac = patch_.points[index(t[2])] - a;
  const Vec3 normal = cross(ab, ac), way = hit.where.point - a;
  const double square = std::max(dot(normal, normal), 1e-300);
  const double second = dot(cross(way, ac), normal) / square, third = dot(cross(ab, way), normal) / square;
  const auto flat = corners(index(hit.triangle));
  return flat[0] + second * (flat[1] - flat[0]) + third * (flat[2] - flat[0]);
}

}  // namespace toile
