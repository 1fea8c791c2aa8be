// Cloths and bodies made by hand for the tests of pictures.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "runtime/body/body.hpp"
#include "runtime/mesh/cloth.hpp"

namespace toile::test {

/// n x n squares of two triangles, `side` [m] long in warp (u) and weft (v).
inline Cloth square_cloth(int n, double side) {
  Cloth cloth;
  cloth.vertex_count = (n + 1) * (n + 1);
  cloth.area_of_vertex.assign(static_cast<std::size_t>(cloth.vertex_count), 0.0);
  const auto vertex = [&](int i, int j) { return j * (n + 1) + i; };
  const auto place = [&](int i, int j) { return Vec2{side * i / n, side * j / n}; };
  const auto add = [&](int i0, int j0, int i1, int j1, int i2, int j2) {
    ClothTriangle triangle;
    triangle.vertices = {vertex(i0, j0), vertex(i1, j1), vertex(i2, j2)};
    triangle.uv = {place(i0, j0), place(i1, j1), place(i2, j2)};
    const double area = side * side / (2.0 * n * n);
    for (const int v : triangle.vertices) cloth.area_of_vertex[static_cast<std::size_t>(v)] += area / 3;
    cloth.area += area;
    cloth.triangles.push_back(triangle);
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      add(i, j, i + 1, j, i + 1, j + 1);
      add(i, j, i + 1, j + 1, i, j + 1);
    }
  }
  return cloth;
}

/// Positions of a square cloth's vertices as a function of (u, v) / side.
inline std::vector<Vec3> placed(int n, const std::function<Vec3(double, double)>& place) {
  std::vector<Vec3> positions;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) positions.push_back(place(static_cast<double>(i) / n, static_cast<double>(j) / n));
  }
  return positions;
}

/// Upright in the plane y = 0, right side to the front: u to the right, v up, centred at `height`.
inline std::vector<Vec3> hung(int n, double side, double height) {
  return placed(n, [=](double u, double v) { return Vec3{side * (u - 0.5), 0, height + side * (v - 0.5)}; });
}

class SphereBody : public Body {
 public:
  SphereBody(Vec3 centre, double radius, int rings) : centre_(centre), radius_(radius) {
    spec_.shape = SphereSpec{radius, centre.z};
    const int around = 2 * rings;
    surface_.points.push_back(centre + Vec3{0, 0, -radius});
    for (int i = 1; i < rings; ++i) {
      const double polar = std::numbers::pi * i / rings;
      for (int k = 0; k < around; ++k) {
        const double angle = 2 * std::numbers::pi * k / around;
        surface_.points.push_back(centre + radius * Vec3{std::sin(polar) * std::cos(angle),
                                                         std::sin(polar) * std::sin(angle), -std::cos(polar)});
      }
    }
    surface_.points.push_back(centre + Vec3{0, 0, radius});
    const auto at = [&](int i, int k) {
      if (i == 0) return 0;
      if (i == rings) return static_cast<int>(surface_.points.size()) - 1;
      return 1 + (i - 1) * around + k % around;
    };
    for (int i = 0; i < rings; ++i) {
      for (int k = 0; k < around; ++k) {
        if (i > 0) surface_.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k)});
        if (i < rings - 1) surface_.triangles.push_back({at(i, k + 1), at(i + 1, k + 1), at(i + 1, k)});
      }
    }
  }
  const BodySpec& spec() const override { return spec_; }
  const Surface& surface() const override { return surface_; }
  const std::vector<BodyLine>& lines() const override { return lines_; }
  std::optional<SurfacePoint> nearest(Vec3 p, double reach) const override {
    const Vec3 out = normalized(p - centre_);
    const double off = distance(p, centre_) - radius_;
    if (off > reach) return std::nullopt;
    return SurfacePoint{centre_ + radius_ * out, out, off, 0};
  }
  Vec3 top() const override { return centre_ + Vec3{0, 0, radius_}; }

 private:
  Vec3 centre_;
  double radius_;
  BodySpec spec_;
  Surface surface_;
  std::vector<BodyLine> lines_;
};

}  // namespace toile::test
