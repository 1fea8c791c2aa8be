#include "runtime/report/projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace toile {

namespace {

constexpr int kLines = 2048;

struct Interval {
  double from = 0, to = 0;
};

/// Where the line of constant y cuts the triangle's projection; y lies between its lowest and highest corner.
Interval cut(const std::array<Vec3, 3>& corners, double y) {
  Interval interval{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = corners[i];
    const Vec3 b = corners[(i + 1) % 3];
    if ((a.y < y) == (b.y < y)) continue;
    const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
    interval.from = std::min(interval.from, x);
    interval.to = std::max(interval.to, x);
  }
  return interval;
}

double length_of_union(std::vector<Interval>& intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from || (a.from == b.from && a.to < b.to); });
  double length = 0;
  double covered_to = -std::numeric_limits<double>::infinity();
  for (const Interval& interval : intervals) {
    length += std::max(0.0, interval.to - std::max(interval.from, covered_to));
    covered_to = std::max(covered_to, interval.to);
  }
  return length;
}

}  // namespace

double projected_area(const Cloth& cloth, const std::vector<Vec3>& positions) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vec3& p : positions) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const double step = (high - low) / kLines;
  if (!(step > 0) || !std::isfinite(step)) return 0;

  std::vector<std::vector<Interval>> lines(kLines);
  for (const ClothTriangle& triangle : cloth.triangles) {
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = positions[static_cast<std::size_t>(triangle.vertices[i])];
    const auto [least, most] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const int first = std::clamp(static_cast<int>(std::ceil((least - low) / step - 0.5)), 0, kLines - 1);
    const int last = std::clamp(static_cast<int>(std::floor((most - low) / step - 0.5)), 0, kLines - 1);
    for (int line = first; line <= last; ++line) {
      const Interval interval = cut(corners, low + (line + 0.5) * step);
      if (interval.from < interval.to) lines[static_cast<std::size_t>(line)].push_back(interval);
    }
  }
  double area = 0;
  for (std::vector<Interval>& line : lines) area += step * length_of_union(line);
  return area;
}

}  // namespace toile
