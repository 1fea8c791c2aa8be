#include "runtime/body/plane_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace toile {
namespace {

// An edge of the surface that the plane crosses, smaller vertex first: a node of the loops.
using Crossed = std::pair<int, int>;

struct Step {
  Crossed from, to;
  friend bool operator<(const Step& a, const Step& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); }
};

// One step a triangle that the plane passes through, directed so that steps chain. A vertex on the plane counts as
// above it, so that every triangle is crossed at two edges or at none.
std::vector<Step> steps_of(const Body::Surface& surface, const std::vector<double>& height) {
  std::vector<Step> steps;
  const auto above = [&](int v) { return height[v] >= 0; };
  for (const auto& t : surface.triangles) {
    Step step{{-1, -1}, {-1, -1}};
    for (int c = 0; c < 3; ++c) {
      const int a = t[c], b = t[(c + 1) % 3];
      if (above(a) == above(b)) continue;
      (above(a) ? step.from : step.to) = std::minmax(a, b);
    }
    if (step.from.first >= 0) steps.push_back(step);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

double distance_to_loop(const std::vector<Vec3>& loop, Vec3 p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = loop[i], d = loop[(i + 1) % loop.size()] - a;
    const double length2 = dot(d, d);
    const double t = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0;
    least = std::min(least, distance(p, a + t * d));
  }
  return least;
}

Vec3 mean(const std::vector<Vec3>& points) {
  Vec3 sum;
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

Vec3 hanging_axis(const Body::Surface& surface, const std::vector<Vec3>& loop, Vec3 normal) {
  if (std::abs(normal.z) >= 0.5) return normal.z < 0 ? normal : -normal;
  return dot(normal, mean(loop) - mean(surface.points)) >= 0 ? normal : -normal;
}

// Turned so as to run counter-clockwise seen along the axis, and to start where the ray from its middle to the front
// crosses it; where there is no front in its plane, to the top.
void from_the_front(std::vector<Vec3>& loop, Vec3 axis) {
  const Vec3 middle = mean(loop);
  Vec3 circulation;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    circulation += cross(loop[i] - middle, loop[(i + 1) % loop.size()] - middle);
  }
  if (dot(circulation, axis) > 0) std::reverse(loop.begin(), loop.end());

  Vec3 front = Vec3{0, -1, 0} + axis.y * axis;
  if (norm(front) < 0.1) front = Vec3{0, 0, 1} - axis.z * axis;
  front = normalized(front);
  const Vec3 side = cross(front, axis);  // positive on the far side of the front, going counter-clockwise
  std::size_t first = 0;
  Vec3 start;
  double farthest = -1;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = loop[i] - middle, b = loop[(i + 1) % loop.size()] - middle;
    const double da = dot(a, side), db = dot(b, side);
    if (!(da > 0) == !(db > 0)) continue;
    const Vec3 p = a + da / (da - db) * (b - a);
    if (dot(p, front) <= farthest) continue;
    farthest = dot(p, front);
    first = (i + 1) % loop.size();
    start = middle + p;
  }
  if (farthest < 0) return;
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
  if (distance(start, loop.front()) > 1e-9) loop.insert(loop.begin(), start);
}

}  // namespace

std::vector<std::vector<Vec3>> plane_loops(const Body::Surface& surface, Vec3 point, Vec3 unit_normal) {
  std::vector<double> height;
  height.reserve(surface.points.size());
  for (const Vec3& p : surface.points) height.push_back(dot(p - point, unit_normal));
  const std::vector<Step> steps = steps_of(surface, height);
  const auto crossing = [&](Crossed edge) {
    const double a = height[edge.first], b = height[edge.second];
    return surface.points[edge.first] + a / (a - b) * (surface.points[edge.second] - surface.points[edge.first]);
  };
  std::vector<std::vector<Vec3>> loops;
  std::vector<bool> done(steps.size(), false);
  for (std::size_t s = 0; s < steps.size(); ++s) {
    std::vector<Vec3> loop;
    std::size_t at = s;
    while (at < steps.size() && !done[at]) {
      done[at] = true;
      const Vec3 p = crossing(steps[at].from);
      if (loop.empty() || distance(loop.back(), p) > 1e-9) loop.push_back(p);
      const Step next{steps[at].to, {-1, -1}};
      at = static_cast<std::size_t>(std::lower_bound(steps.begin(), steps.end(), next) - steps.begin());
    }
    if (loop.size() > 1 && distance(loop.back(), loop.front()) <= 1e-9) loop.pop_back();
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

std::optional<BodyLine> cut_line(const Body::Surface& surface, const MeshSpec::Line& line) {
  const Vec3 point{line.px, line.py, line.pz};
  const Vec3 normal = normalized(Vec3{line.nx, line.ny, line.nz});
  BodyLine result{line.name, {}, 0, {}};
  double nearest = std::numeric_limits<double>::infinity();
  for (std::vector<Vec3>& loop : plane_loops(surface, point, normal)) {
    const double d = distance_to_loop(loop, point);
    if (d >= nearest) continue;
    nearest = d;
    result.points = std::move(loop);
  }
  if (result.points.empty()) return std::nullopt;
  result.axis = hanging_axis(surface, result.points, normal);
  from_the_front(result.points, result.axis);
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    result.girth += distance(result.points[i], result.points[(i + 1) % result.points.size()]);
  }
  return result;
}

}  // namespace toile
