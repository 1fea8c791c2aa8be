// Turning in space about an axis.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace toile {

/// `v` turned by `angle` [rad] about axis 0, 1 or 2 (x, y, z), by the right-hand rule.
inline std::array<double, 3> turned(const std::array<double, 3>& v, std::size_t axis, double angle) {
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  const double c = std::cos(angle), s = std::sin(angle);
  std::array<double, 3> w = v;
  w[a] = c * v[a] - s * v[b];
  w[b] = s * v[a] + c * v[b];
  return w;
}

}  // namespace toile
