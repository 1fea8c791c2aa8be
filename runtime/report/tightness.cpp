#include "runtime/report/tightness.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

/// Of the thread through a triangle: from … to in the pattern, and the triangle.
struct Stretch {
  double from = 0, to = 0;  // [m]
  int triangle = 0;
};

/// A place of the pattern, along the thread and across it.
struct OnThread {
  double along = 0, across = 0;
};
OnThread on_thread(Vec2 uv, bool warp) {
  return warp ? OnThread{uv.x, uv.y} : OnThread{uv.y, uv.x};
}

std::optional<Stretch> crossing(const ClothTriangle& triangle, bool warp, double across, int number) {
  std::optional<Stretch> crossing;
  for (std::size_t k = 0; k < 3; ++k) {
    const OnThread a = on_thread(triangle.uv[k], warp), b = on_thread(triangle.uv[(k + 1) % 3], warp);
    if ((a.across <= across) == (b.across <= across)) continue;
    const double at = a.along + (across - a.across) / (b.across - a.across) * (b.along - a.along);
    if (!crossing) crossing = Stretch{at, at, number};
    crossing->from = std::min(crossing->from, at);
    crossing->to = std::max(crossing->to, at);
  }
  return crossing;
}

/// The thread across the piece through the middle of that triangle, without what lies beyond a gap.
std::vector<Stretch> thread_through(const DrapedGarment& draped, int middle, bool warp) {
  const std::vector<ClothTriangle>& triangles = draped.cloth->triangles;
  const auto& uv = triangles[index(middle)].uv;
  const OnThread at = on_thread(1.0 / 3 * (uv[0] + uv[1] + uv[2]), warp);
  const std::vector<PieceId>& pieces = draped.mesh->p.piece_of_triangle;
  std::vector<Stretch> thread;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (pieces[t] != pieces[index(middle)]) continue;
    if (const auto stretch = crossing(triangles[t], warp, at.across, static_cast<int>(t))) thread.push_back(*stretch);
  }
  std::ranges::sort(thread, {}, &Stretch::from);
  constexpr double gap = 1e-6;  // [m]
  std::size_t first = 0, last = thread.size();
  double reached = thread.empty() ? 0 : thread.front().to;
  for (std::size_t i = 1; i < thread.size(); ++i) {
    const double from_here = thread[i].from - reached;
    reached = std::max(reached, thread[i].to);
    if (from_here < gap) continue;
    if (thread[i].from <= at.along) first = i;
    if (thread[i].from > at.along) last = std::min(last, i);
  }
  return {thread.begin() + static_cast<std::ptrdiff_t>(first), thread.begin() + static_cast<std::ptrdiff_t>(last)};
}

}  // namespace

Tightness tightest(const DrapedGarment& draped) {
  const Drape& drape = *draped.drape;
  Tightness tightest;
  if (drape.pressure.empty()) return tightest;
  const auto vertex = static_cast<int>(std::ranges::max_element(drape.pressure) - drape.pressure.begin());
  if (!(drape.pressure[index(vertex)] > 0)) return tightest;
  tightest.pressure_Pa = drape.pressure[index(vertex)];
  tightest.at = drape.positions[index(vertex)];
  // Of the triangles about it, the one that draws the hardest.
  int hardest = -1;
  double force = 0;
  for (std::size_t t = 0; t < draped.cloth->triangles.size(); ++t) {
    const auto& of = draped.cloth->triangles[t].vertices;
    if (std::ranges::find(of, vertex) == of.end()) continue;
    const double warp = drape.stress_warp[t], weft = drape.stress_weft[t];
    if (hardest >= 0 && std::max(warp, weft) <= force) continue;
    hardest = static_cast<int>(t);
    force = std::max(warp, weft);
    tightest.along_warp = warp > weft;
  }
  if (hardest < 0) return tightest;
  const std::vector<double>& strains = tightest.along_warp ? drape.strain_warp : drape.strain_weft;
  tightest.piece = draped.mesh->p.piece_of_triangle[index(hardest)];
  tightest.strain = strains[index(hardest)];
  for (const Stretch& stretch : thread_through(draped, hardest, tightest.along_warp)) {
    tightest.length_m += stretch.to - stretch.from;
    tightest.short_m += (stretch.to - stretch.from) * strains[index(stretch.triangle)];
  }
  return tightest;
}

}  // namespace toile
