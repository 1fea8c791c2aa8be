#include "runtime/body/superellipse.hpp"

#include <cmath>
#include <numbers>

namespace toile {
namespace {

// The quadrant from the front (0, -b) to the side (a, 0), b = 1, finely sampled.
std::vector<Vec3> fine_quadrant(double ratio, double n, int samples) {
  std::vector<Vec3> points(static_cast<std::size_t>(samples) + 1);
  for (int i = 0; i <= samples; ++i) {
    const double t = 0.5 * std::numbers::pi * i / samples;
    points[i] = {ratio * std::pow(std::sin(t), 2 / n), -std::pow(std::cos(t), 2 / n), 0};
  }
  points.front() = {0, -1, 0};
  points.back() = {ratio, 0, 0};
  return points;
}

std::vector<Vec3> evenly_spaced(const std::vector<Vec3>& fine, int divisions) {
  std::vector<double> arc(fine.size(), 0.0);
  for (std::size_t i = 1; i < fine.size(); ++i) arc[i] = arc[i - 1] + distance(fine[i - 1], fine[i]);
  std::vector<Vec3> even{fine.front()};
  std::size_t j = 0;
  for (int k = 1; k < divisions; ++k) {
    const double s = arc.back() * k / divisions;
    while (arc[j + 1] < s) ++j;
    const double t = (s - arc[j]) / (arc[j + 1] - arc[j]);
    even.push_back((1 - t) * fine[j] + t * fine[j + 1]);
  }
  even.push_back(fine.back());
  return even;
}

}  // namespace

std::vector<Vec3> superellipse(int count, double girth, double ratio, double n) {
  const int quarter = count / 4;
  const std::vector<Vec3> q = evenly_spaced(fine_quadrant(ratio, n, 8 * quarter), quarter);
  double length = 0;
  for (int i = 0; i < quarter; ++i) length += distance(q[i], q[i + 1]);
  const double scale = girth / (4 * length);
  std::vector<Vec3> ring(static_cast<std::size_t>(4 * quarter));
  for (int i = 0; i < quarter; ++i) {
    ring[i] = scale * q[i];
    ring[quarter + i] = scale * Vec3{q[quarter - i].x, -q[quarter - i].y, 0};
    ring[2 * quarter + i] = scale * Vec3{-q[i].x, -q[i].y, 0};
    ring[3 * quarter + i] = scale * Vec3{-q[quarter - i].x, q[quarter - i].y, 0};
  }
  return ring;
}

}  // namespace toile
