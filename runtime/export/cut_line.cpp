#include "runtime/export/cut_line.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace toile {

namespace {

constexpr double kChordError = 5e-5;  // [m]
constexpr double kLongest = 0.05;     // [m]
constexpr double kMitre = 2;          // of the wider allowance

// One edge of the outline with the line parallel to it.
struct Hem {
  std::vector<Vec2> points;  // moved outwards
  Vec2 leaving, arriving;    // unit tangents at its ends
  Vec2 begin, corner;        // where the edge itself starts and ends
  double allowance = 0;
  AllowanceCorner style = AllowanceCorner::Mitred;
  std::string name;
  bool is_mouth = false;
};

Hem parallel(const Curve& curve, double allowance, AllowanceCorner style) {
  Hem hem;
  hem.allowance = allowance;
  hem.style = style;
  hem.begin = curve.start();
  hem.corner = curve.end();
  hem.leaving = curve.tangent(0);
  hem.arriving = curve.tangent(curve.length());
  for (const double s : curve.divide(kChordError, kLongest)) {
    hem.points.push_back(curve.at(s) - allowance * perpendicular(curve.tangent(s)));
  }
  return hem;
}

// A straight line through a point.
struct Ray {
  Vec2 from, along;

  double side(Vec2 p) const { return cross(along, p - from); }
  Vec2 reflected(Vec2 p) const {
    const Vec2 unit = along / norm(along), d = p - from;
    return from + 2 * dot(d, unit) * unit - d;
  }
};

// Where a line of points first comes to the ray; what lies before or behind there is left out.
std::optional<std::vector<Vec2>> cut_at(const std::vector<Vec2>& points, const Ray& ray, bool keep_before) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double a = ray.side(points[i]), b = ray.side(points[i + 1]);
    if ((a < 0) == (b < 0) && a != 0) continue;
    const Vec2 met = a == b ? points[i] : points[i] + a / (a - b) * (points[i + 1] - points[i]);
    std::vector<Vec2> kept;
    if (keep_before) {
      kept.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      kept.push_back(met);
    } else {
      kept.push_back(met);
      kept.insert(kept.end(), points.begin() + static_cast<std::ptrdiff_t>(i) + 1, points.end());
    }
    return kept;
  }
  return std::nullopt;
}

// The parallel line of a dart's neighbour from the dart's leg on, away from the dart. It is drawn on over its end, for
// a leg that leans outwards.
std::optional<std::vector<Vec2>> beside_leg(const Hem& hem, bool at_end, const Ray& leg) {
  std::vector<Vec2> line = hem.points;
  if (at_end) std::reverse(line.begin(), line.end());
  const Vec2 on = at_end ? hem.arriving : -hem.leaving;
  line.insert(line.begin(), line.front() + 2 * hem.allowance * on);
  return cut_at(line, leg, false);
}

// Folded to one side, the dart's own cloth lies on the allowance of that side and is cut with it: opened again it
// stands over the mouth like a roof.
std::optional<std::vector<Vec2>> roof(Vec2 from, Vec2 tip, Vec2 to, const Hem& neighbour, bool onto_first) {
  const Vec2 own = onto_first ? from : to, other = onto_first ? to : from;
  const Ray leg{tip, own - tip};
  const auto beside = beside_leg(neighbour, onto_first, leg);
  if (!beside) return std::nullopt;
  std::vector<Vec2> half;
  for (const Vec2 p : *beside) half.push_back(leg.reflected(p));
  const Ray centre{tip, (own - tip) / norm(own - tip) + (other - tip) / norm(other - tip)};
  const auto up = cut_at(half, centre, true);
  if (!up) return std::nullopt;
  std::vector<Vec2> line = *up;
  for (std::size_t i = up->size() - 1; i-- > 0;) line.push_back(centre.reflected((*up)[i]));
  if (!onto_first) std::reverse(line.begin(), line.end());
  return line;
}

// The edges around a dart, by index.
struct Mouth {
  std::size_t hem = 0;
  Vec2 from, tip, to;
  bool first = false, second = false;  // onto which leg it is pressed
};

void raise_roofs(const std::vector<Mouth>& mouths, std::vector<Hem>& hems) {
  for (const Mouth& mouth : mouths) {
    if (!mouth.first && !mouth.second) continue;
    const std::size_t n = hems.size();
    Hem &before = hems[(mouth.hem + n - 1) % n], &after = hems[(mouth.hem + 1) % n];
    const auto line = roof(mouth.from, mouth.tip, mouth.to, mouth.first ? before : after, mouth.first);
    const auto first = beside_leg(before, true, {mouth.tip, mouth.from - mouth.tip});
    const auto second = beside_leg(after, false, {mouth.tip, mouth.to - mouth.tip});
    if (!line || !first || !second) continue;
    before.points.assign(first->rbegin(), first->rend());
    after.points = *second;
    hems[mouth.hem].points = *line;
    hems[mouth.hem].is_mouth = true;
  }
}

std::vector<Hem> parallels(const std::vector<PieceEdge>& edges) {
  std::vector<Hem> hems;
  std::vector<Mouth> mouths;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!edges[i].is_dart_leg) {
      hems.push_back(parallel(edges[i].curve, edges[i].allowance, edges[i].corner));
      hems.back().name = edges[i].name;
      continue;
    }
    // Two legs in a row are one dart; its mouth takes the allowance of the edge that it stands on.
    const PieceEdge& second = edges[(i + 1) % edges.size()];
    const PieceEdge& host = edges[(i + edges.size() - 1) % edges.size()];
    const PieceEdge& after = edges[(i + 2) % edges.size()];
    const Vec2 from = edges[i].curve.start(), to = second.curve.end();
    if (!host.is_dart_leg && !after.is_dart_leg) {
      mouths.push_back({hems.size(), from, edges[i].curve.end(), to, edges[i].pressed_onto, second.pressed_onto});
    }
    hems.push_back(
        parallel(line(from, to), host.is_dart_leg ? after.allowance : host.allowance, AllowanceCorner::Mitred));
    ++i;
  }
  raise_roofs(mouths, hems);
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

// One side of a corner, told from the corner: its parallel line away from it, and the directions that lead there.
struct Flank {
  std::vector<Vec2> line;
  Vec2 away;     // unit vector along the edge, away from the corner
  Vec2 outward;  // unit vector across it
  double allowance = 0;
};

Flank flank(const Hem& hem, bool ends_here) {
  Flank side{hem.points, ends_here ? -hem.arriving : hem.leaving,
             -perpendicular(ends_here ? hem.arriving : hem.leaving), hem.allowance};
  if (ends_here) std::reverse(side.line.begin(), side.line.end());
  return side;
}

// The line drawn on over the corner by more than any corner treatment can ask for.
std::vector<Vec2> drawn_on(const Flank& side, double reach) {
  std::vector<Vec2> line = side.line;
  line.insert(line.begin(), line.front() - reach * side.away);
  return line;
}

// The edge's allowance ends square to it, where its seam drawn on meets the neighbour's line.
std::optional<std::vector<Vec2>> squared(Vec2 corner, const Flank& own, const Flank& other, double reach) {
  auto line = cut_at(drawn_on(other, reach), {corner, own.away}, false);
  if (line) line->insert(line->begin(), line->front() + own.allowance * own.outward);
  return line;
}

// The edge's allowance ends as the neighbour's line reflected in the edge, so that folded back it lies on the cloth.
std::optional<std::vector<Vec2>> mirrored(Vec2 corner, const Flank& own, const Flank& other, double reach) {
  const Ray edge{corner, own.away};
  const auto inside = cut_at(drawn_on(other, reach), edge, false);
  if (!inside) return std::nullopt;
  std::vector<Vec2> folded;
  for (const Vec2 p : *inside) folded.push_back(edge.reflected(p));
  const auto up = cut_at(folded, {corner + own.allowance * own.outward, own.away}, true);
  if (!up) return std::nullopt;
  std::vector<Vec2> line(up->rbegin(), up->rend());
  line.insert(line.end(), inside->begin() + 1, inside->end());
  return line;
}

// Gives a corner the form that one of its edges asks for; false where neither does or where it cannot be.
bool treat(Hem& before, Hem& after) {
  constexpr double kTurn = 0.2;  // [rad] parts of an edge run on into each other, and so do copies over a fold
  if (before.name == after.name && std::abs(cross(before.arriving, after.leaving)) < kTurn) return false;
  const bool by_after = after.style != AllowanceCorner::Mitred;
  const AllowanceCorner style = by_after ? after.style : before.style;
  if (style == AllowanceCorner::Mitred) return false;
  if (style == AllowanceCorner::Bevelled) return true;
  const Flank first = flank(before, true), second = flank(after, false);
  const Flank &own = by_after ? second : first, &other = by_after ? first : second;
  const double reach = 3 * (before.allowance + after.allowance);
  const auto line = style == AllowanceCorner::Square ? squared(before.corner, own, other, reach)
                                                     : mirrored(before.corner, own, other, reach);
  if (!line) return false;
  Hem &own_hem = by_after ? after : before, &other_hem = by_after ? before : after;
  if (by_after) {
    other_hem.points.assign(line->rbegin(), line->rend());
  } else {
    other_hem.points = *line;
  }
  // The edge's own line starts where the neighbour's has come to.
  (by_after ? own_hem.points.front() : own_hem.points.back()) = line->front();
  return true;
}

}  // namespace

std::vector<Vec2> cut_line(const std::vector<PieceEdge>& edges) {
  std::vector<Hem> hems = parallels(edges);
  for (std::size_t i = 0; i < hems.size() && hems.size() > 1; ++i) {
    Hem& after = hems[(i + 1) % hems.size()];
    if (hems[i].is_mouth || after.is_mouth) continue;
    if (distance(hems[i].points.back(), after.points.front()) < 1e-9) continue;
    if (treat(hems[i], after)) continue;
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
