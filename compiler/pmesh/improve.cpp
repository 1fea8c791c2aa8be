#include "compiler/pmesh/improve.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace toile {
namespace {

constexpr int kSweeps = 8;
constexpr int kFlipPasses = 8;

using Triangles = std::vector<std::array<int, 3>>;

/// For each corner the triangle across the opposite edge, or -1; none across the edges of the lines that are kept.
std::vector<std::array<int, 3>> neighbours(const Triangles& triangles, const std::vector<std::vector<int>>& kept) {
  struct Half {
    int low, high, triangle, corner;
  };
  std::vector<Half> halves;
  halves.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(triangles[t][(c + 1) % 3], triangles[t][(c + 2) % 3]);
      halves.push_back({low, high, t, c});
    }
  }
  std::sort(halves.begin(), halves.end(),
            [](const Half& a, const Half& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
  std::set<std::pair<int, int>> walls;
  for (const auto& line : kept) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) walls.insert(std::minmax(line[i], line[i + 1]));
  }
  std::vector<std::array<int, 3>> across(triangles.size(), {-1, -1, -1});
  for (std::size_t i = 0; i + 1 < halves.size(); ++i) {
    const Half &a = halves[i], &b = halves[i + 1];
    if (a.low != b.low || a.high != b.high || walls.contains({a.low, a.high})) continue;
    across[a.triangle][a.corner] = b.triangle;
    across[b.triangle][b.corner] = a.triangle;
  }
  return across;
}

class Flipper {
 public:
  Flipper(const std::vector<Vec2>& points, Triangles& triangles, const std::vector<std::vector<int>>& kept)
      : points_(points), triangles_(triangles), across_(neighbours(triangles, kept)) {}

  /// Lawson's flips, until none helps.
  void run() {
    for (int pass = 0; pass < kFlipPasses; ++pass) {
      bool any = false;
      for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
        for (int c = 0; c < 3; ++c) any |= flip_if_better(t, c);
      }
      if (!any) break;
    }
  }

 private:
  bool flip_if_better(int t, int c) {
    const int u = across_[t][c];
    if (u < 0) return false;
    const int apex = triangles_[t][c], right = triangles_[t][(c + 1) % 3], left = triangles_[t][(c + 2) % 3];
    int d = 0;
    while (d < 3 && (triangles_[u][d] == right || triangles_[u][d] == left)) ++d;
    if (d == 3) return false;
    const int opposite = triangles_[u][d];
    if (!better_flipped(points_[apex], points_[right], points_[left], points_[opposite])) return false;

    const int beyond_right = across_[u][(d + 1) % 3];  // across (left's side) edge (opposite, right)
    const int beyond_left = across_[t][(c + 1) % 3];   // across edge (left, apex)
    const int keep_right = across_[t][(c + 2) % 3];    // across edge (apex, right)
    const int keep_left = across_[u][(d + 2) % 3];     // across edge (left, opposite)
    triangles_[t] = {apex, right, opposite};
    triangles_[u] = {apex, opposite, left};
    across_[t] = {beyond_right, u, keep_right};
    across_[u] = {keep_left, beyond_left, t};
    relink(beyond_right, u, t);
    relink(beyond_left, t, u);
    return true;
  }

  void relink(int triangle, int from, int to) {
    if (triangle < 0) return;
    std::replace(across_[triangle].begin(), across_[triangle].end(), from, to);
  }

  /// The angles facing the edge add up to more than a half turn, clearly.
  static bool better_flipped(Vec2 a, Vec2 r, Vec2 l, Vec2 o) {
    const double sa = cross(r - a, l - a), ca = dot(r - a, l - a);
    const double so = cross(l - o, r - o), co = dot(l - o, r - o);
    const double sine_of_sum = sa * co + ca * so;
    const double scale = norm(r - a) * norm(l - a) * norm(l - o) * norm(r - o);
    return sine_of_sum < -1e-9 * scale && cross(r - a, o - a) > 0 && cross(o - a, l - a) > 0;
  }

  const std::vector<Vec2>& points_;
  Triangles& triangles_;
  std::vector<std::array<int, 3>> across_;
};

/// The edges facing each node, counter-clockwise, as one flat list.
struct Stars {
  std::vector<int> first;
  std::vector<std::array<int, 2>> edges;

  Stars(const Triangles& triangles, std::size_t node_count) : first(node_count + 1), edges(3 * triangles.size()) {
    for (const auto& t : triangles) {
      for (const int v : t) ++first[v + 1];
    }
    for (std::size_t v = 0; v < node_count; ++v) first[v + 1] += first[v];
    std::vector<int> next(first.begin(), first.end() - 1);
    for (const auto& t : triangles) {
      for (int c = 0; c < 3; ++c) edges[next[t[c]]++] = {t[(c + 1) % 3], t[(c + 2) % 3]};
    }
  }
};

struct Quadratic {
  double value = 0;
  Vec2 gradient;
  double xx = 0, xy = 0, yy = 0;
};

constexpr double kFlat = 1e300;

/// The squared inverse mean ratio of (x, b, c), unscaled: ((|x-b|^2 + |x-c|^2 + |b-c|^2) / (2 area))^2.
double shape(Vec2 x, Vec2 b, Vec2 c) {
  const double twice_area = cross(b - x, c - x);
  if (twice_area <= 0) return kFlat;
  const double f = (dot(x - b, x - b) + dot(x - c, x - c) + dot(b - c, b - c)) / twice_area;
  return f * f;
}

/// The same with its derivatives by x. With f = n/d, d linear in x: f'' = (4 I - f' d'^T - d' f'^T)/d.
void add_shape(Vec2 x, Vec2 b, Vec2 c, Quadratic& sum) {
  const double d = cross(b - x, c - x);
  const double n = dot(x - b, x - b) + dot(x - c, x - c) + dot(b - c, b - c);
  const double f = n / d;
  const Vec2 dd = perpendicular(c - b);
  const Vec2 df = (1 / d) * (2.0 * (x - b) + 2.0 * (x - c) - f * dd);
  const double xx = (4 - 2 * df.x * dd.x) / d;
  const double yy = (4 - 2 * df.y * dd.y) / d;
  const double xy = -(df.x * dd.y + df.y * dd.x) / d;
  sum.value += f * f;
  sum.gradient = sum.gradient + 2 * f * df;
  sum.xx += 2 * (df.x * df.x + f * xx);
  sum.xy += 2 * (df.x * df.y + f * xy);
  sum.yy += 2 * (df.y * df.y + f * yy);
}

void move(std::vector<Vec2>& points, int node, const Stars& stars) {
  const auto begin = stars.edges.begin() + stars.first[node], end = stars.edges.begin() + stars.first[node + 1];
  const Vec2 x = points[node];
  Quadratic q;
  for (auto e = begin; e != end; ++e) {
    if (cross(points[(*e)[0]] - x, points[(*e)[1]] - x) <= 0) return;
    add_shape(x, points[(*e)[0]], points[(*e)[1]], q);
  }
  const double det = q.xx * q.yy - q.xy * q.xy;
  if (!(det > 0)) return;
  Vec2 step{(q.xy * q.gradient.y - q.yy * q.gradient.x) / det, (q.xy * q.gradient.x - q.xx * q.gradient.y) / det};
  for (int halving = 0; halving < 4; ++halving, step = 0.5 * step) {
    double value = 0;
    for (auto e = begin; e != end && value < q.value; ++e) {
      value += shape(x + step, points[(*e)[0]], points[(*e)[1]]);
    }
    if (value < q.value) {
      points[node] = x + step;
      return;
    }
  }
}

}  // namespace

void improve(std::vector<Vec2>& points, std::vector<std::array<int, 3>>& triangles, int fixed,
             const std::vector<std::vector<int>>& kept) {
  Flipper flipper(points, triangles, kept);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const Stars stars(triangles, points.size());
    for (int node = fixed; node < static_cast<int>(points.size()); ++node) move(points, node, stars);
    flipper.run();
  }
  for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
}

}  // namespace toile
