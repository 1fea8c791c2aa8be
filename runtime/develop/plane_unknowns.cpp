#include "runtime/develop/plane_unknowns.hpp"

#include <algorithm>
#include <numeric>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr std::size_t worth_dissecting = 20000;  // points of a plane mesh

template <std::size_t N>
std::vector<int> unknowns_of(const std::array<int, N>& points) {
  std::vector<int> all;
  for (const int point : points) {
    all.push_back(2 * point);
    all.push_back(2 * point + 1);
  }
  return all;
}

/// Unknowns that do not hold the grain, in that order of the points.
std::vector<int> numbered_free(const FlatteningInput& input, const std::vector<int>& points) {
  std::vector<int> reduced(2 * input.start.size(), 0);
  for (const FlatteningInput::GrainLine& line : input.grain) {
    reduced[index(2 * line.from)] = reduced[index(2 * line.from + 1)] = -1;
    reduced[index(2 * line.to + 1)] = -1;
  }
  int next = 0;
  for (const int point : points) {
    for (const int unknown : {2 * point, 2 * point + 1}) {
      if (reduced[index(unknown)] == 0) reduced[index(unknown)] = next++;
    }
  }
  return reduced;
}

}  // namespace

std::array<int, 4> points_of(const LengthMatch& match) {
  return {match.first[0], match.first[1], match.second[0], match.second[1]};
}

std::vector<int> plane_unknowns(const std::array<int, 3>& triangle) {
  return unknowns_of(triangle);
}

std::vector<int> plane_unknowns(const LengthMatch& match) {
  std::vector<int> all;
  for (const int unknown : unknowns_of(points_of(match))) {
    if (std::find(all.begin(), all.end(), unknown) == all.end()) all.push_back(unknown);
  }
  return all;
}

std::vector<int> free_plane_unknowns(const FlatteningInput& input) {
  std::vector<int> points(input.start.size());
  std::iota(points.begin(), points.end(), 0);
  return numbered_free(input, points);
}

std::vector<int> well_ordered_plane_unknowns(const FlatteningInput& input) {
  std::vector<int> points(input.start.size());
  std::iota(points.begin(), points.end(), 0);
  std::vector<std::vector<int>> joined;
  for (const auto& t : input.triangles) joined.push_back({t[0], t[1], t[2]});
  for (const LengthMatch& match : input.matches) {
    std::array<int, 4> ends = points_of(match);
    std::sort(ends.begin(), ends.end());
    joined.emplace_back(ends.begin(), std::unique(ends.begin(), ends.end()));
  }
  Cholesky cholesky;
  if (points.size() < worth_dissecting) cholesky.order_by_degree();
  return numbered_free(input, cholesky.good_order(SparseMatrix(points, joined)));
}

std::vector<std::vector<int>> plane_elements(const FlatteningInput& input) {
  std::vector<std::vector<int>> elements;
  for (const auto& triangle : input.triangles) elements.push_back(plane_unknowns(triangle));
  for (const LengthMatch& match : input.matches) elements.push_back(plane_unknowns(match));
  return elements;
}

void add_match(const LengthMatch& match, const Matrix8& hessian, const std::vector<std::int32_t>& places,
               SparseMatrix& matrix) {
  const std::vector<int> each = unknowns_of(points_of(match)), once = plane_unknowns(match);
  const auto row = [&](int unknown) {
    return static_cast<std::size_t>(std::find(once.begin(), once.end(), unknown) - once.begin());
  };
  for (std::size_t i = 0; i < each.size(); ++i) {
    for (std::size_t j = 0; j < each.size(); ++j) {
      const std::size_t r = row(each[i]), c = row(each[j]);
      if (r < c) continue;
      const std::int32_t place = places[r * (r + 1) / 2 + c];
      if (place >= 0) matrix.add_at(place, hessian(static_cast<int>(i), static_cast<int>(j)));
    }
  }
}

}  // namespace toile
