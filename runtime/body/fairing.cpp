#include "runtime/body/fairing.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

std::vector<std::vector<int>> neighbours_of(const Body::Surface& surface) {
  std::vector<std::vector<int>> neighbours(surface.points.size());
  for (const auto& t : surface.triangles) {
    for (int c = 0; c < 3; ++c) {
      neighbours[t[c]].push_back(t[(c + 1) % 3]);
      neighbours[t[c]].push_back(t[(c + 2) % 3]);
    }
  }
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

// The umbrellas that free vertices have a part in: those of free vertices and of their neighbours.
class Umbrellas {
 public:
  Umbrellas(const Body::Surface& surface, const std::vector<bool>& free)
      : neighbours_(neighbours_of(surface)), free_(free) {
    for (int v = 0; v < static_cast<int>(free.size()); ++v) {
      const auto& around = neighbours_[v];
      if (free[v] || std::any_of(around.begin(), around.end(), [&](int w) { return free[w]; })) concerned_.push_back(v);
    }
  }

  /// Half the gradient of the sum of squares of the umbrella vectors of `x`, on the free vertices.
  std::vector<Vec3> gradient(const std::vector<Vec3>& x) const {
    std::vector<Vec3> result(x.size());
    for (const int v : concerned_) {
      const auto& around = neighbours_[v];
      const double weight = 1 / static_cast<double>(around.size());
      Vec3 umbrella = -x[v];
      for (const int w : around) umbrella += weight * x[w];
      result[v] += -umbrella;
      for (const int w : around) result[w] += weight * umbrella;
    }
    for (std::size_t v = 0; v < x.size(); ++v) {
      if (!free_[v]) result[v] = {};
    }
    return result;
  }

 private:
  std::vector<std::vector<int>> neighbours_;
  const std::vector<bool>& free_;
  std::vector<int> concerned_;
};

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

}  // namespace

// Conjugate gradients: a few hundred unknowns, so a few hundred steps.
void fair(Body::Surface& surface, const std::vector<bool>& free) {
  constexpr int most_steps = 3000;
  constexpr double accuracy = 1e-20;  // of the squared residual
  const Umbrellas umbrellas(surface, free);
  std::vector<Vec3> residual = umbrellas.gradient(surface.points);
  for (Vec3& r : residual) r = -r;
  std::vector<Vec3> direction = residual;
  double squared = dot(residual, residual);
  const double enough = accuracy * squared;
  for (int step = 0; step < most_steps && squared > enough; ++step) {
    const std::vector<Vec3> image = umbrellas.gradient(direction);
    const double curvature = dot(direction, image);
    if (!(curvature > 0)) return;
    const double length = squared / curvature;
    for (std::size_t v = 0; v < free.size(); ++v) {
      surface.points[v] += length * direction[v];
      residual[v] += -length * image[v];
    }
    const double next = dot(residual, residual);
    for (std::size_t v = 0; v < free.size(); ++v) direction[v] = residual[v] + next / squared * direction[v];
    squared = next;
  }
}

}  // namespace toile
