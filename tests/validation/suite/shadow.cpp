#include "tests/validation/suite/shadow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::validation {
namespace {

constexpr double pixel = 0.00025;

}  // namespace

double shadow_area(const Cloth& cloth, const std::vector<Vec3>& positions) {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}, high = -low;
  for (const Vec3& p : positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto columns = static_cast<std::size_t>((high.x - low.x) / pixel) + 1;
  const auto rows = static_cast<std::size_t>((high.y - low.y) / pixel) + 1;
  std::vector<bool> dark(columns * rows);
  const auto cell = [](double value, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(count)));
  };
  for (const ClothTriangle& triangle : cloth.triangles) {
    std::array<Vec2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 at = positions[static_cast<std::size_t>(triangle.vertices[k])];
      p[k] = (Vec2{at.x, at.y} - low) / pixel;
    }
    const double turn = cross(p[1] - p[0], p[2] - p[0]);
    if (turn == 0) continue;
    if (turn < 0) std::swap(p[1], p[2]);
    const std::size_t last_row = cell(std::max({p[0].y, p[1].y, p[2].y}) + 1, rows);
    const std::size_t last_column = cell(std::max({p[0].x, p[1].x, p[2].x}) + 1, columns);
    for (std::size_t row = cell(std::min({p[0].y, p[1].y, p[2].y}) - 1, rows); row < last_row; ++row) {
      for (std::size_t column = cell(std::min({p[0].x, p[1].x, p[2].x}) - 1, columns); column < last_column; ++column) {
        const Vec2 middle{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) inside &= cross(p[(k + 1) % 3] - p[k], middle - p[k]) >= 0;
        if (inside) dark[row * columns + column] = true;
      }
    }
  }
  return static_cast<double>(std::count(dark.begin(), dark.end(), true)) * pixel * pixel;
}

}  // namespace toile::validation
