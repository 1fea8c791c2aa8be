#include "runtime/contact/untangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/contact/flaps.hpp"
#include "runtime/contact/piercing.hpp"
#include "runtime/contact/self_intersections.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr int most_steps = 100;
constexpr int further_steps = 3;
constexpr int rings_about_crossings = 3;

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
    const Vector3 line = ends[0].at - vertex_at(q, common);
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

namespace {

/// What the vertices are pulled by: flaps back to where they came from, all else so that the lines get shorter.
Vector pull_apart(const Cloth& cloth, const Vector& q, const std::vector<std::array<int, 2>>& pairs, bool by_flaps) {
  FlapPull flaps = by_flaps ? pull_flaps(cloth, q, pairs) : FlapPull{Vector::Zero(q.size()), {}};
  flaps.of_flap.resize(pairs.size(), false);
  Crossings others;
  others.gradient = Vector::Zero(q.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (flaps.of_flap[i]) continue;
    add_segment(q, cloth.triangles[index(pairs[i][0])].vertices, cloth.triangles[index(pairs[i][1])].vertices, others);
  }
  return flaps.force - others.gradient;
}

}  // namespace

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
  Vector best = q, last = Vector::Zero(q.size());
  int least = -1;
  for (int step = 0; step <= 2 * most_steps; ++step) {
    // The lines get shorter first; what that does not undo hangs through the cloth as a flap.
    if (step == most_steps) q = best;
    const std::vector<std::array<int, 2>> pairs = intersecting_triangles(cloth, positions(cloth, q));
    const int count = static_cast<int>(pairs.size());
    if (least < 0 || count < least) {
      least = count;
      best = q;
    }
    if (least == 0 || step == 2 * most_steps || job.is_cancelled()) break;
    const Vector motion = readily(pull_apart(cloth, q, pairs, step >= most_steps));
    const double size = longest_of(cloth, motion);
    if (!(size > 0)) break;
    last = longest / size * motion;
    q += last;
  }
  q = best;
  // What has just come apart hardly has room between: on the same way, as long as nothing else gets crossed.
  for (int step = 0; least == 0 && last.squaredNorm() > 0 && step < further_steps; ++step) {
    const Vector further = q + last;
    if (!intersecting_triangles(cloth, positions(cloth, further)).empty()) break;
    q = further;
  }
  return least;
}

}  // namespace toile
