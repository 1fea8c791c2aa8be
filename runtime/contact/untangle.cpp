#include "runtime/contact/untangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "runtime/contact/self_intersections.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr int most_steps = 100;
constexpr int rings_about_crossings = 3;

/// Where an edge goes through a triangle, and how that place moves: a vertex moved by m moves it by w (m - e (n.m) /
/// (n.e)) when it is of the edge, and by w e (n.m) / (n.e) when it is of the triangle.
struct Piercing {
  Vector3 at = Vector3::Zero();
  Vector3 edge = Vector3::Zero(), normal = Vector3::Zero();
  std::array<int, 2> edge_vertices{};
  std::array<double, 2> edge_weights{};
  std::array<int, 3> triangle_vertices{};
  std::array<double, 3> triangle_weights{};

  /// What a pull on the place is for the vertices.
  void spread(const Vector3& pull, Vector& gradient) const {
    const double along = edge.dot(normal);
    const Vector3 by_triangle = normal * (edge.dot(pull) / along);
    for (std::size_t k = 0; k < 2; ++k) {
      gradient.segment<3>(3 * edge_vertices[k]) += edge_weights[k] * (pull - by_triangle);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      gradient.segment<3>(3 * triangle_vertices[k]) += triangle_weights[k] * by_triangle;
    }
  }
};

Vector3 at(const Vector& q, int vertex) {
  return q.segment<3>(3 * vertex);
}

std::optional<Piercing> pierce(const Vector& q, int from, int to, const std::array<int, 3>& triangle) {
  const Vector3 a = at(q, triangle[0]), b = at(q, triangle[1]), c = at(q, triangle[2]), start = at(q, from);
  Piercing piercing;
  piercing.normal = (b - a).cross(c - a);
  piercing.edge = at(q, to) - start;
  const double along = piercing.normal.dot(piercing.edge);
  if (along == 0) return std::nullopt;
  const double t = piercing.normal.dot(a - start) / along;
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  piercing.at = start + t * piercing.edge;
  const double square = piercing.normal.squaredNorm();
  const double wb = (piercing.at - a).cross(c - a).dot(piercing.normal) / square;
  const double wc = (b - a).cross(piercing.at - a).dot(piercing.normal) / square;
  if (!(wb >= 0 && wc >= 0 && wb + wc <= 1)) return std::nullopt;
  piercing.edge_vertices = {from, to};
  piercing.edge_weights = {1 - t, t};
  piercing.triangle_vertices = triangle;
  piercing.triangle_weights = {1 - wb - wc, wb, wc};
  return piercing;
}

bool has(const std::array<int, 3>& triangle, int vertex) {
  return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

void add_piercings(const Vector& q, const std::array<int, 3>& sides_of, const std::array<int, 3>& triangle,
                   std::vector<Piercing>& piercings) {
  for (std::size_t k = 0; k < 3; ++k) {
    const int from = sides_of[k], to = sides_of[(k + 1) % 3];
    if (has(triangle, from) || has(triangle, to)) continue;
    if (const auto piercing = pierce(q, from, to, triangle)) piercings.push_back(*piercing);
  }
}

/// The line in which two triangles cross.
void add_segment(const Vector& q, const std::array<int, 3>& first, const std::array<int, 3>& second, Crossings& sum) {
  std::vector<Piercing> ends;
  add_piercings(q, first, second, ends);
  add_piercings(q, second, first, ends);
  int common = -1;
  for (const int v : first) {
    if (has(second, v)) common = v;
  }
  if (common >= 0 && ends.size() == 1) {
    const Vector3 line = ends[0].at - at(q, common);
    const double length = line.norm();
    if (length == 0) return;
    sum.length += length;
    ends[0].spread(line / length, sum.gradient);
    sum.gradient.segment<3>(3 * common) -= line / length;
  } else if (ends.size() == 2) {
    const Vector3 line = ends[0].at - ends[1].at;
    const double length = line.norm();
    if (length == 0) return;
    sum.length += length;
    ends[0].spread(line / length, sum.gradient);
    ends[1].spread(-line / length, sum.gradient);
  }
}

std::vector<Vec3> positions(const Cloth& cloth, const Vector& q) {
  std::vector<Vec3> positions;
  positions.reserve(index(cloth.vertex_count));
  for (int v = 0; v < cloth.vertex_count; ++v) positions.push_back(to_vec3(q.segment<3>(3 * v)));
  return positions;
}

double longest_of(const Cloth& cloth, const Vector& step) {
  double longest = 0;
  for (int v = 0; v < cloth.vertex_count; ++v) longest = std::max(longest, step.segment<3>(3 * v).norm());
  return longest;
}

}  // namespace

Crossings crossings(const Cloth& cloth, const Vector& q) {
  Crossings sum;
  sum.gradient = Vector::Zero(q.size());
  for (const auto& [first, second] : intersecting_triangles(cloth, positions(cloth, q))) {
    ++sum.pairs;
    add_segment(q, cloth.triangles[index(first)].vertices, cloth.triangles[index(second)].vertices, sum);
  }
  return sum;
}

std::vector<bool> about_crossings(const Cloth& cloth, const Vector& q) {
  std::vector<bool> about(index(cloth.vertex_count), false);
  for (const auto& pair : intersecting_triangles(cloth, positions(cloth, q))) {
    for (const int triangle : pair) {
      for (const int v : cloth.triangles[index(triangle)].vertices) about[index(v)] = true;
    }
  }
  for (int ring = 0; ring < rings_about_crossings; ++ring) {
    const std::vector<bool> inner = about;
    for (const SMesh::Edge& edge : cloth.edges) {
      const bool reached = inner[index(edge.vertices[0])] || inner[index(edge.vertices[1])];
      for (const int v : edge.vertices) about[index(v)] = about[index(v)] || reached;
    }
  }
  return about;
}

int untangle(const Cloth& cloth, const std::function<Vector(const Vector& force)>& readily, double longest,
             const Job& job, Vector& q) {
  Vector best = q;
  int least = -1;
  for (int step = 0; step <= most_steps; ++step) {
    const Crossings crossed = crossings(cloth, q);
    if (least < 0 || crossed.pairs < least) {
      least = crossed.pairs;
      best = q;
    }
    if (least == 0 || step == most_steps || job.is_cancelled()) break;
    const Vector motion = readily(-crossed.gradient);
    const double size = longest_of(cloth, motion);
    if (!(size > 0)) break;
    q += longest / size * motion;
  }
  q = best;
  return least;
}

}  // namespace toile
