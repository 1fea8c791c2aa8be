#include "runtime/export/cut_line.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace toile {

namespace {

constexpr double kChordError = 5e-5;  // [m]
constexpr double kLongest = 0.05;     // [m]
constexpr double kMitre = 2;          // of the wider allowance

// One edge of the outline with the line parallel to it.
struct Hem {
  std::vector<Vec2> points;  // moved outwards
  Vec2 leaving, arriving;    // unit tangents at its ends
  Vec2 corner;               // where the edge itself ends
  double allowance = 0;
};

Hem parallel(const Curve& curve, double allowance) {
  Hem hem;
  hem.allowance = allowance;
  hem.corner = curve.end();
  hem.leaving = curve.tangent(0);
  hem.arriving = curve.tangent(curve.length());
  for (const double s : curve.divide(kChordError, kLongest)) {
    hem.points.push_back(curve.at(s) - allowance * perpendicular(curve.tangent(s)));
  }
  return hem;
}

std::vector<Hem> parallels(const std::vector<PieceEdge>& edges) {
  std::vector<Hem> hems;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!edges[i].is_dart_leg) {
      hems.push_back(parallel(edges[i].curve, edges[i].allowance));
      continue;
    }
    // Two legs in a row are one dart; its mouth takes the allowance of the edge that it stands on.
    const PieceEdge& second = edges[(i + 1) % edges.size()];
    const PieceEdge& host = edges[(i + edges.size() - 1) % edges.size()];
    const PieceEdge& after = edges[(i + 2) % edges.size()];
    hems.push_back(parallel(line(edges[i].curve.start(), second.curve.end()),
                            host.is_dart_leg ? after.allowance : host.allowance));
    ++i;
  }
  return hems;
}

std::optional<Vec2> meeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 u = b - a, v = d - c;
  const double area = cross(u, v);
  if (area == 0) return std::nullopt;
  const double t = cross(c - a, v) / area, s = cross(c - a, u) / area;
  if (t < 0 || t > 1 || s < 0 || s > 1) return std::nullopt;
  return a + t * u;
}

// At an inner corner the two lines cross: both are cut off there, at the crossing nearest to the corner.
bool trim(Hem& before, Hem& after) {
  const std::size_t n = before.points.size();
  for (std::size_t reach = 0; reach + 2 <= n + after.points.size(); ++reach) {
    for (std::size_t i = 0; i <= reach; ++i) {
      const std::size_t j = reach - i;
      if (i + 2 > n || j + 2 > after.points.size()) continue;
      const auto found =
          meeting(before.points[n - 2 - i], before.points[n - 1 - i], after.points[j], after.points[j + 1]);
      if (!found) continue;
      before.points.resize(n - 1 - i);
      before.points.push_back(*found);
      after.points.erase(after.points.begin(), after.points.begin() + static_cast<std::ptrdiff_t>(j));
      after.points.front() = *found;
      return true;
    }
  }
  return false;
}

// At an outer corner both lines are drawn out until they meet, unless that is too far.
void mitre(Hem& before, const Hem& after) {
  const double area = cross(before.arriving, after.leaving);
  if (std::abs(area) < 1e-6) return;
  const double t = cross(after.points.front() - before.points.back(), after.leaving) / area;
  const Vec2 tip = before.points.back() + t * before.arriving;
  const double reach = kMitre * std::max(before.allowance, after.allowance);
  if (t > 0 && distance(tip, before.corner) <= reach + 1e-9) before.points.push_back(tip);
}

}  // namespace

std::vector<Vec2> cut_line(const std::vector<PieceEdge>& edges) {
  std::vector<Hem> hems = parallels(edges);
  for (std::size_t i = 0; i < hems.size() && hems.size() > 1; ++i) {
    Hem& after = hems[(i + 1) % hems.size()];
    if (distance(hems[i].points.back(), after.points.front()) < 1e-9) continue;
    if (!trim(hems[i], after)) mitre(hems[i], after);
  }
  std::vector<Vec2> outline;
  for (const Hem& hem : hems) {
    for (const Vec2 point : hem.points) {
      if (outline.empty() || distance(outline.back(), point) > 1e-6) outline.push_back(point);
    }
  }
  return outline;
}

}  // namespace toile
