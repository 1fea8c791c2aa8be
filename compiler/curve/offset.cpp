// Parallel curves. Each segment is moved aside, gaps outside of corners are closed by arcs, and the whole is cut where
// it meets itself; what comes nearer to the curve than it should is the fold, and left out.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/curve/bernstein.hpp"
#include "compiler/curve/places.hpp"
#include "compiler/curve/segment.hpp"
#include "compiler/curve/shape.hpp"

namespace toile {
namespace {

using std::numbers::pi;

constexpr double fitted = 1e-7;         // [m] how near a cubic comes to the parallel of a cubic
constexpr double same_place = 1e-6;     // [m]
constexpr double folded_in = 1e-6;      // [m] nearer to the curve than this is a fold
constexpr double same_crossing = 5e-5;  // [m] between the ends of parts that meet: half the width of a drawn line
constexpr int deepest_halving = 9;

Vec2 left_of(const Segment& segment, double t) {
  return perpendicular(unit_tangent(segment, t));
}

Vec2 beside(const Segment& segment, double t, double d) {
  return point(segment, t) + d * left_of(segment, t);
}

/// How fast the parallel runs for the curve's 1; below 0 it runs backwards.
double pace(const Segment& segment, double t, double d) {
  return 1 - d * curvature(segment, t);
}

/// A cubic with the parallel's ends, directions and paces there.
BezierSegment hermite(const Segment& segment, double t0, double t1, double d) {
  const double third = (t1 - t0) / 3;
  const Vec2 p0 = beside(segment, t0, d), p3 = beside(segment, t1, d);
  return {p0, p0 + third * pace(segment, t0, d) * derivative(segment, t0),
          p3 - third * pace(segment, t1, d) * derivative(segment, t1), p3};
}

void fit(const Segment& segment, double t0, double t1, double d, int depth, std::vector<Segment>& out) {
  const Segment cubic = hermite(segment, t0, t1, d);
  const Segment piece = part(segment, t0, t1);
  double worst = 0;
  for (const double t : {0.2, 0.4, 0.5, 0.6, 0.8}) {
    const Vec2 off = point(cubic, t) - point(piece, t);
    // Where it lies along the parallel does not matter, how far from it does.
    worst = std::max(worst, std::abs(norm(off) - std::abs(d)) + std::abs(dot(off, unit_tangent(piece, t))) * 0.01);
  }
  if (worst <= fitted || depth >= deepest_halving) {
    out.push_back(cubic);
    return;
  }
  fit(segment, t0, (t0 + t1) / 2, d, depth + 1, out);
  fit(segment, (t0 + t1) / 2, t1, d, depth + 1, out);
}

/// Parameters at which the parallels of a cubic on either side turn back: there the curvature is 1 / d or -1 / d, so
/// that the sixth power of the speed is the square of d times the cross product of speed and acceleration.
std::vector<double> turning_places(const BezierSegment& b, double d) {
  const Vec2 v0 = 3 * (b.p1 - b.p0), v1 = 3 * (b.p2 - b.p1), v2 = 3 * (b.p3 - b.p2);
  const Vec2 a0 = 2 * (v1 - v0), a1 = 2 * (v2 - v1);
  const Bernstein vx{v0.x, v1.x, v2.x}, vy{v0.y, v1.y, v2.y};
  const Bernstein square = vx * vx + vy * vy;
  const Bernstein bend = vx * Bernstein{a0.y, a1.y} + vy * Bernstein{-a0.x, -a1.x};
  const Bernstein raised(7, -d * d);  // of the degree that the right side lacks
  return roots(square * square * square + bend * bend * raised);
}

/// The parallel of one segment, without the parts that run backwards.
void move_aside(const Segment& segment, double d, std::vector<Segment>& out) {
  if (const auto* line = std::get_if<LineSegment>(&segment)) {
    if (norm(line->to - line->from) > 0) out.emplace_back(LineSegment{beside(segment, 0, d), beside(segment, 1, d)});
  } else if (const auto* arc = std::get_if<ArcSegment>(&segment)) {
    const double radius = arc->radius - std::copysign(d, arc->sweep * d);
    if (radius > same_place) out.emplace_back(ArcSegment{arc->centre, radius, arc->start, arc->sweep});
  } else {
    std::vector<double> cuts = turning_places(std::get<BezierSegment>(segment), d);
    cuts.push_back(1);
    double before = 0;
    for (const double cut : cuts) {
      if (cut > before && pace(segment, (before + cut) / 2, d) > 0) fit(segment, before, cut, d, 0, out);
      before = cut;
    }
  }
}

/// Around a corner, where the parallels of its two sides gape.
void round_corner(const Segment& before, const Segment& after, double d, std::vector<Segment>& out) {
  const Vec2 from = unit_tangent(before, 1), to = unit_tangent(after, 0);
  const double turn = std::atan2(cross(from, to), dot(from, to));
  if (turn * d >= 0 || std::abs(turn) < 1e-9) return;
  const Vec2 begin = d * perpendicular(from);
  out.emplace_back(ArcSegment{point(before, 1), std::abs(d), std::atan2(begin.y, begin.x), turn});
}

/// The chain cut wherever two of its segments meet.
std::vector<Curve> cut_at_meetings(const std::vector<Segment>& chain) {
  std::vector<Curve> pieces;
  std::vector<std::vector<double>> cuts(chain.size());
  for (const Segment& segment : chain) pieces.emplace_back(std::vector{segment});
  for (std::size_t i = 0; i < chain.size(); ++i) {
    for (std::size_t j = i + 1; j < chain.size(); ++j) {
      for (const Crossing& c : intersections(pieces[i], pieces[j])) {
        cuts[i].push_back(c.s_first);
        cuts[j].push_back(c.s_second);
      }
    }
  }
  std::vector<Curve> parts;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    std::sort(cuts[i].begin(), cuts[i].end());
    cuts[i].push_back(pieces[i].length());
    double before = 0;
    for (const double cut : cuts[i]) {
      if (cut - before < same_place) continue;
      parts.push_back(pieces[i].part(before, cut));
      before = cut;
    }
  }
  return parts;
}

/// The parts of a piece that keep their distance from the curve. Between cuts it is all or nothing, but for what comes
/// too near to an end of the curve, about which the parallel does not run.
void keep_sound_parts(const Curve& curve, double d, const Curve& piece, std::vector<Curve>& kept) {
  constexpr int samples = 8;
  const auto folded = [&](double s) {
    const Vec2 p = piece.at(s);
    return distance(curve.at(nearest_place(curve, p)), p) < std::abs(d) - folded_in;
  };
  const auto sample = [&](int i) { return piece.length() * i / samples; };
  const auto edge_between = [&](double a, double b) {
    const bool state = folded(a);
    while (std::abs(b - a) > same_place / 10) (folded((a + b) / 2) == state ? a : b) = (a + b) / 2;
    return (a + b) / 2;
  };
  double begin = 0;
  bool sound = !folded(sample(0));
  const auto keep_to = [&](double end) {
    const bool whole = begin == 0 && end == piece.length();
    if (sound && (whole || end - begin > same_crossing)) kept.push_back(piece.part(begin, end));
    begin = end;
  };
  for (int i = 1; i <= samples; ++i) {
    if (folded(sample(i)) != sound) continue;
    keep_to(edge_between(sample(i - 1), sample(i)));
    sound = !sound;
  }
  keep_to(piece.length());
}

}  // namespace

std::optional<Curve> offset(const Curve& curve, double d) {
  if (curve.empty()) return std::nullopt;
  if (d == 0) return curve;
  const std::vector<Segment>& segments = curve.segments();
  const bool closed = distance(curve.start(), curve.end()) < same_place;
  std::vector<Segment> chain;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    move_aside(segments[i], d, chain);
    if (i + 1 < segments.size()) round_corner(segments[i], segments[i + 1], d, chain);
    if (i + 1 == segments.size() && closed) round_corner(segments[i], segments[0], d, chain);
  }
  std::vector<Curve> kept;
  for (const Curve& piece : cut_at_meetings(chain)) keep_sound_parts(curve, d, piece, kept);
  for (std::size_t i = 1; i < kept.size(); ++i) {
    if (distance(kept[i - 1].end(), kept[i].start()) > same_crossing) return std::nullopt;
  }
  return kept.empty() ? std::nullopt : std::optional(join(kept));
}

}  // namespace toile
