// A hemisphere cut by darts from its rim to near its pole, for flattening.
#pragma once

#include <cmath>
#include <numbers>

#include "runtime/develop/flatten.hpp"

namespace toile::test {

/// `darts` slits along meridians, evenly round, up to ring `tip` of `rings`; `across` triangle sides a gore and ring.
/// The start is the map that keeps lengths from the pole. The two sides of a slit are matched.
inline FlatteningInput hemisphere_with_darts(double radius, int darts, int rings, int tip, int across) {
  using std::numbers::pi;
  FlatteningInput input;
  const auto add = [&](int ring, double turn) {
    const double off = pi / 2 * ring / rings, round = 2 * pi * turn;
    input.target.push_back(
        {radius * std::sin(off) * std::cos(round), radius * std::sin(off) * std::sin(round), radius * std::cos(off)});
    input.start.push_back(radius * off * direction(round));
    return static_cast<int>(input.target.size()) - 1;
  };
  // Point i of a gore on a ring; on a slit each gore has its own.
  std::vector<std::vector<std::vector<int>>> points(static_cast<std::size_t>(darts));
  const int pole = add(0, 0);
  for (int gore = 0; gore < darts; ++gore) {
    auto& rows = points[static_cast<std::size_t>(gore)];
    rows.push_back(std::vector<int>(static_cast<std::size_t>(across) + 1, pole));
    for (int ring = 1; ring <= rings; ++ring) {
      std::vector<int> row;
      for (int i = 0; i <= across; ++i) {
        const bool shared = ring <= tip;
        const auto before = static_cast<std::size_t>(gore - 1), here = static_cast<std::size_t>(ring);
        if (shared && i == 0 && gore > 0) {
          row.push_back(points[before][here].back());
        } else if (shared && i == across && gore == darts - 1) {
          row.push_back(points[0][here].front());
        } else {
          row.push_back(add(ring, (gore + static_cast<double>(i) / across) / darts));
        }
      }
      rows.push_back(row);
    }
    for (std::size_t ring = 0; ring < static_cast<std::size_t>(rings); ++ring) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(across); ++i) {
        const auto &inner = rows[ring], &outer = rows[ring + 1];
        input.triangles.push_back({inner[i], outer[i], outer[i + 1]});
        if (ring > 0) input.triangles.push_back({inner[i], outer[i + 1], inner[i + 1]});
      }
    }
  }
  for (std::size_t gore = 0; gore < points.size(); ++gore) {
    const auto &left = points[gore], &right = points[(gore + 1) % points.size()];
    for (auto ring = static_cast<std::size_t>(tip); ring < static_cast<std::size_t>(rings); ++ring) {
      LengthMatch match{{left[ring].back(), left[ring + 1].back()}, {right[ring].front(), right[ring + 1].front()}};
      match.length = radius * pi / 2 / rings;
      match.seam = static_cast<int>(gore);
      input.matches.push_back(match);
    }
  }
  // From the pole down the middle of the first gore, which is turned to lie along the warp.
  const auto middle = points[0].back()[static_cast<std::size_t>(across / 2)];
  const Vec2 along = direction(
      -std::atan2(input.start[static_cast<std::size_t>(middle)].y, input.start[static_cast<std::size_t>(middle)].x));
  for (Vec2& p : input.start) p = p.x * along + p.y * perpendicular(along);
  input.grain = {{pole, middle}};
  return input;
}

}  // namespace toile::test
