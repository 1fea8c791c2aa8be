#include "runtime/develop/patch.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "runtime/body/triangle_tree.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

using Triangles = std::vector<std::array<int, 3>>;
using Edge = std::array<int, 2>;

constexpr double line_step = 0.001;    // [m] between the samples of a line that part a surface
constexpr double on_the_plane = 1e-7;  // [m] nearer to a plane a point lies on it
constexpr double first_past_the_line = 0.01, last_past_the_line = 0.06;  // [m] down the limb from a line

Edge edge_of(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The triangles next to each triangle, over its three edges; -1 where there is none.
std::vector<std::array<int, 3>> neighbours(const Triangles& triangles) {
  std::map<Edge, std::array<int, 2>> sides;  // triangle and edge in it, as one number
  std::vector<std::array<int, 3>> found(triangles.size(), {-1, -1, -1});
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge edge = edge_of(triangles[t][i], triangles[t][(i + 1) % 3]);
      const auto [other, is_new] = sides.try_emplace(edge, std::array{static_cast<int>(t), static_cast<int>(i)});
      if (is_new) continue;
      found[t][i] = other->second[0];
      found[index(other->second[0])][index(other->second[1])] = static_cast<int>(t);
    }
  }
  return found;
}

/// The triangles that can be reached from one of them without leaving those that `belongs` says yes to.
template <class Belongs>
std::vector<char> flood(const Triangles& triangles, int from, Belongs belongs) {
  const std::vector<std::array<int, 3>> next = neighbours(triangles);
  std::vector<char> in(triangles.size(), 0);
  std::vector<int> open{from};
  in[index(from)] = 1;
  while (!open.empty()) {
    const int t = open.back();
    open.pop_back();
    for (const int other : next[index(t)]) {
      if (other < 0 || in[index(other)] || !belongs(other)) continue;
      in[index(other)] = 1;
      open.push_back(other);
    }
  }
  return in;
}

/// The chosen triangles with the points that they have.
Patch taken(const Body::Surface& surface, const std::vector<char>& chosen) {
  Patch patch;
  std::vector<int> number(surface.points.size(), -1);
  for (std::size_t t = 0; t < chosen.size(); ++t) {
    if (!chosen[t]) continue;
    std::array<int, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      int& point = number[index(surface.triangles[t][i])];
      if (point < 0) {
        point = static_cast<int>(patch.points.size());
        patch.points.push_back(surface.points[index(surface.triangles[t][i])]);
      }
      corners[i] = point;
    }
    patch.triangles.push_back(corners);
  }
  return patch;
}

/// The loops of edges that only one triangle has; empty where a point has two such edges running from it.
std::vector<std::vector<int>> boundary_loops(const Triangles& triangles) {
  std::map<std::array<int, 2>, int> directed;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++directed[{t[i], t[(i + 1) % 3]}];
  }
  std::map<int, int> next;
  for (const auto& [edge, count] : directed) {
    if (directed.contains({edge[1], edge[0]})) continue;
    if (!next.emplace(edge[0], edge[1]).second) return {};
  }
  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    std::vector<int> loop;
    for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
      if (loop.empty()) loop.push_back(at->first);
      loop.push_back(at->second);
      next.erase(at);
    }
    loop.pop_back();
    loops.push_back(std::move(loop));
  }
  return loops;
}

int euler(const Patch& patch) {
  std::vector<Edge> edges;
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(edge_of(t[i], t[(i + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  const auto distinct = std::unique(edges.begin(), edges.end()) - edges.begin();
  return static_cast<int>(patch.points.size()) - static_cast<int>(distinct) + static_cast<int>(patch.triangles.size());
}

/// Triangles that hang on by a point alone are dropped from the rim until its every point has one way on.
void make_rim_simple(Patch& patch) {
  for (std::size_t round = 0; round < 50 && boundary_loops(patch.triangles).empty(); ++round) {
    std::map<std::array<int, 2>, int> directed;
    for (const auto& t : patch.triangles) {
      for (std::size_t i = 0; i < 3; ++i) directed[{t[i], t[(i + 1) % 3]}] = 1;
    }
    std::map<int, int> ways;
    for (const auto& [edge, count] : directed) {
      if (!directed.contains({edge[1], edge[0]})) ++ways[edge[0]];
    }
    std::erase_if(patch.triangles, [&](const auto& t) {
      return std::any_of(t.begin(), t.end(), [&](int p) { return ways.contains(p) && ways[p] > 1; });
    });
  }
}

Patch renumbered(const Patch& patch) {
  return taken({patch.points, patch.triangles}, std::vector<char>(patch.triangles.size(), 1));
}

/// Divides triangles along a half plane and parts the surface there.
class Slit {
 public:
  Slit(Patch& patch, Vec3 from, Vec3 along, Vec3 normal) : patch_(patch), from_(from), along_(along), normal_(normal) {
    for (const Vec3 p : patch.points) add_side(p);
  }

  void cut() {
    Triangles parts;
    for (const auto& triangle : patch_.triangles) divide(triangle, parts);
    std::map<int, int> behind;  // the second copy of a point on the slit
    for (auto& triangle : parts) {
      if (lies_before(triangle)) continue;
      for (int& point : triangle) {
        const Vec3 place = patch_.points[index(point)];
        if (sides_[index(point)] != 0 || !on_this_half(place)) continue;
        const auto [copy, is_new] = behind.try_emplace(point, static_cast<int>(patch_.points.size()));
        if (is_new) patch_.points.push_back(place);
        point = copy->second;
      }
    }
    patch_.triangles = std::move(parts);
  }

 private:
  bool on_this_half(Vec3 p) const { return dot(p - from_, along_) > 0; }
  void add_side(Vec3 p) {
    const double off = dot(p - from_, normal_);
    offs_.push_back(off);
    sides_.push_back(std::abs(off) < on_the_plane ? 0 : off > 0 ? 1 : -1);
  }
  bool lies_before(const std::array<int, 3>& triangle) const {
    double sum = 0;
    for (const int point : triangle) sum += point < static_cast<int>(sides_.size()) ? sides_[index(point)] : 0;
    return sum > 0;
  }

  /// The point where an edge goes through the half plane, made on demand; -1 where it does not.
  int crossing(int a, int b) {
    if (sides_[index(a)] * sides_[index(b)] != -1) return -1;
    const Edge edge = edge_of(a, b);
    if (const auto known = crossings_.find(edge); known != crossings_.end()) return known->second;
    const double share = offs_[index(edge[0])] / (offs_[index(edge[0])] - offs_[index(edge[1])]);
    const Vec3 p =
        patch_.points[index(edge[0])] + share * (patch_.points[index(edge[1])] - patch_.points[index(edge[0])]);
    int made = -1;
    if (on_this_half(p)) {
      made = static_cast<int>(patch_.points.size());
      patch_.points.push_back(p);
      offs_.push_back(0);
      sides_.push_back(0);
    }
    crossings_[edge] = made;
    return made;
  }

  void divide(const std::array<int, 3>& triangle, Triangles& parts) {
    std::vector<int> ring;
    std::vector<std::size_t> on_it;  // places in the ring where the plane goes through
    for (std::size_t i = 0; i < 3; ++i) {
      if (sides_[index(triangle[i])] == 0) on_it.push_back(ring.size());
      ring.push_back(triangle[i]);
      const int between = crossing(triangle[i], triangle[(i + 1) % 3]);
      if (between < 0) continue;
      on_it.push_back(ring.size());
      ring.push_back(between);
    }
    if (on_it.size() < 2 || ring.size() == 3) {
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) parts.push_back({ring[0], ring[i], ring[i + 1]});
      return;
    }
    // Each of the two sides of the chord is a fan about its first point.
    for (const auto& [begin, end] : {std::pair{on_it[0], on_it[1]}, std::pair{on_it[1], on_it[0] + ring.size()}}) {
      for (std::size_t i = begin + 1; i + 1 <= end; ++i) {
        parts.push_back({ring[begin % ring.size()], ring[i % ring.size()], ring[(i + 1) % ring.size()]});
      }
    }
  }

  Patch& patch_;
  Vec3 from_, along_, normal_;
  std::vector<double> offs_;
  std::vector<int> sides_;  // of the plane: before 1, behind -1, on it 0
  std::map<Edge, int> crossings_;
};

bool is_disc(Patch& patch) {
  const auto loops = boundary_loops(patch.triangles);
  if (loops.size() != 1 || euler(patch) != 1) return false;
  patch.boundary = loops.front();
  return true;
}

}  // namespace

std::optional<Patch> patch_round(const Body::Surface& surface, Vec3 centre, double reach, std::string& error) {
  const TriangleTree tree(surface);
  const TriangleTree::Hit nearest = tree.nearest(centre, reach);
  if (nearest.triangle < 0) {
    error = "its centre lies farther from the body than it reaches";
    return std::nullopt;
  }
  const Vec3 from = nearest.where.point;
  const auto near = [&](int t) {
    const auto corner = [&](std::size_t i) { return surface.points[index(surface.triangles[index(t)][i])]; };
    return distance(closest_on_triangle(from, corner(0), corner(1), corner(2)).point, from) <= reach;
  };
  Patch patch = taken(surface, flood(surface.triangles, nearest.triangle, near));
  make_rim_simple(patch);
  patch = renumbered(patch);
  if (is_disc(patch)) return patch;
  error = "the part of the body that it reaches is no disc: it goes all the way round";
  return std::nullopt;
}

std::optional<Patch> patch_of_limb(const Body::Surface& surface, const BodyLine& line, Vec3 middle, Vec3 open,
                                   double reach, std::string& error) {
  const TriangleTree tree(surface);
  std::vector<char> on_line(surface.triangles.size(), 0);
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vec3 a = line.points[i], b = line.points[(i + 1) % line.points.size()];
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / line_step)));
    for (int k = 0; k < steps; ++k) {
      const Vec3 p = a + (static_cast<double>(k) / steps) * (b - a);
      tree.within(p, line_step, [&](const TriangleTree::Hit& hit) { on_line[index(hit.triangle)] = 1; });
    }
  }
  const auto depth = [&](int t) {
    double least = 1e300;
    for (const int p : surface.triangles[index(t)]) {
      least = std::min(least, dot(surface.points[index(p)] - middle, line.axis));
    }
    return least;
  };
  // Some way down from one of the line's points is a triangle that the line does not touch.
  int seed = -1;
  for (double way = first_past_the_line; seed < 0 && way < last_past_the_line; way *= 1.5) {
    for (const Vec3 p : line.points) {
      const TriangleTree::Hit hit = tree.nearest(p + way * line.axis, way / 2);
      if (hit.triangle < 0 || on_line[index(hit.triangle)]) continue;
      seed = hit.triangle;
      break;
    }
  }
  if (seed < 0) {
    error = "nothing of the body lies beyond the line";
    return std::nullopt;
  }
  std::vector<char> chosen =
      flood(surface.triangles, seed, [&](int t) { return !on_line[index(t)] && depth(t) <= reach; });
  for (std::size_t t = 0; t < chosen.size(); ++t) chosen[t] = static_cast<char>(chosen[t] | on_line[t]);
  Patch patch = taken(surface, chosen);
  make_rim_simple(patch);
  patch = renumbered(patch);
  if (euler(patch) != 0 || boundary_loops(patch.triangles).size() != 2) {
    error = "what it reaches of the body is no open limb: give it less reach than to the limb's end";
    return std::nullopt;
  }
  const Vec3 normal = cross(line.axis, open);
  Slit(patch, middle, open, normal).cut();
  patch = renumbered(patch);
  if (is_disc(patch)) return patch;
  error = "the limb is not cut open there: give it less reach than to its end, or another angle for the cut";
  return std::nullopt;
}

}  // namespace toile
