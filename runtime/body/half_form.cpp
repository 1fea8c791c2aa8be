#include "runtime/body/half_form.hpp"

#include "runtime/body/fairing.hpp"

namespace toile {

int HalfForm::add(Vec3 p, bool is_free) {
  points.push_back(p);
  free.push_back(is_free);
  return static_cast<int>(points.size()) - 1;
}

std::vector<int> HalfForm::add(const std::vector<Vec3>& ring, bool is_free) {
  std::vector<int> ids;
  ids.reserve(ring.size());
  for (const Vec3& p : ring) ids.push_back(add(p, is_free));
  return ids;
}

void HalfForm::quad(int a, int b, int c, int d) {
  if (distance(points[a], points[d]) <= distance(points[b], points[c])) {
    triangles.push_back({a, b, d});
    triangles.push_back({a, d, c});
  } else {
    triangles.push_back({a, b, c});
    triangles.push_back({b, d, c});
  }
}

void HalfForm::join_strips(const std::vector<int>& lower, const std::vector<int>& upper) {
  for (std::size_t i = 0; i + 1 < lower.size(); ++i) quad(lower[i], lower[i + 1], upper[i], upper[i + 1]);
}

void HalfForm::join_loops(const std::vector<int>& lower, const std::vector<int>& upper) {
  join_strips(lower, upper);
  quad(lower.back(), lower.front(), upper.back(), upper.front());
}

WholeForm complete(const HalfForm& half) {
  const std::size_t n = half.points.size();
  std::vector<bool> used(n, false);
  for (const auto& t : half.triangles) {
    for (const int v : t) used[v] = true;
  }
  WholeForm whole{{}, std::vector<int>(n, -1), std::vector<int>(n, -1)};
  std::vector<Vec3>& points = whole.surface.points;
  std::vector<bool> free;
  for (std::size_t i = 0; i < n; ++i) {
    if (!used[i]) continue;
    const Vec3 p = half.points[i];
    whole.whole_of_half[i] = whole.mirror_of_half[i] = static_cast<int>(points.size());
    points.push_back(p);
    free.push_back(half.free[i]);
    if (p.x == 0) continue;
    whole.mirror_of_half[i] = static_cast<int>(points.size());
    points.push_back({-p.x, p.y, p.z});
    free.push_back(half.free[i]);
  }
  const auto& left = whole.whole_of_half;
  const auto& right = whole.mirror_of_half;
  for (const auto& [a, b, c] : half.triangles) {
    whole.surface.triangles.push_back({left[a], left[b], left[c]});
    whole.surface.triangles.push_back({right[a], right[c], right[b]});
  }
  fair(whole.surface, free);
  for (std::size_t i = 0; i < n; ++i) {
    if (!used[i]) continue;
    Vec3& p = points[left[i]];
    if (left[i] == right[i])
      p.x = 0;
    else
      points[right[i]] = {-p.x, p.y, p.z};
  }
  return whole;
}

}  // namespace toile
