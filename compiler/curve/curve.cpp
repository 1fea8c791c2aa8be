#include "compiler/curve/curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/curve/segment.hpp"

namespace toile {
namespace {

// A place on a curve: which segment, and that segment's own parameter.
struct Place {
  std::size_t segment = 0;
  double t = 0;
};

Place locate(const std::vector<Segment>& segments, const std::vector<double>& ends, double s) {
  const auto after = std::upper_bound(ends.begin(), ends.end(), s);
  const std::size_t i = after == ends.end() ? ends.size() - 1 : static_cast<std::size_t>(after - ends.begin());
  const double begin = i > 0 ? ends[i - 1] : 0;
  return {i, parameter_at(segments[i], s - begin, ends[i] - begin)};
}

template <class Change>
std::vector<Segment> each(const std::vector<Segment>& segments, Change change) {
  std::vector<Segment> changed;
  changed.reserve(segments.size());
  for (const Segment& segment : segments) changed.push_back(change(segment));
  return changed;
}

constexpr int kMostDivisions = 1'000'000;

// Halves the stretch [s0, s1] of a segment until its chord is near enough, and appends the ends of all stretches.
void divide_stretch(const Segment& segment, double begin, double length, double s0, double s1, double chord_error,
                    int depth, std::vector<double>& out) {
  const double t0 = parameter_at(segment, s0, length), t1 = parameter_at(segment, s1, length);
  if (depth < 16 && stray(part(segment, t0, t1)) > chord_error) {
    const double middle = (s0 + s1) / 2;
    divide_stretch(segment, begin, length, s0, middle, chord_error, depth + 1, out);
    divide_stretch(segment, begin, length, middle, s1, chord_error, depth + 1, out);
    return;
  }
  out.push_back(begin + s1);
}

// Appends the points after the first of a polygon that keeps to the cubic, halving it in its own parameter.
void follow(const BezierSegment& bezier, double chord_error, int depth, std::vector<Vec2>& points) {
  const Segment whole = bezier;
  if (depth >= 16 || !(stray(whole) > chord_error)) return points.push_back(bezier.p3);
  follow(std::get<BezierSegment>(toile::part(whole, 0, 0.5)), chord_error, depth + 1, points);
  follow(std::get<BezierSegment>(toile::part(whole, 0.5, 1)), chord_error, depth + 1, points);
}

// The least number of equal parts of an arc whose sagittae stay within the error.
int arc_divisions(const ArcSegment& arc, double chord_error) {
  const double cosine = std::clamp(1 - chord_error / arc.radius, 0.0, 1.0);
  const double widest = 2 * std::acos(cosine);
  const double parts = std::abs(arc.sweep) / std::max(widest, 1e-6);
  return static_cast<int>(std::min(std::ceil(parts - 1e-9), double{kMostDivisions}));
}

}  // namespace

Curve::Curve(std::vector<Segment> segments) : segments_(std::move(segments)) {
  double sum = 0;
  ends_.reserve(segments_.size());
  for (const Segment& segment : segments_) ends_.push_back(sum += length_between(segment, 0, 1));
}

double Curve::length() const {
  return ends_.empty() ? 0 : ends_.back();
}
Vec2 Curve::start() const {
  return empty() ? Vec2{} : point(segments_.front(), 0);
}
Vec2 Curve::end() const {
  return empty() ? Vec2{} : point(segments_.back(), 1);
}

Vec2 Curve::at(double s) const {
  if (empty()) return {};
  const Place place = locate(segments_, ends_, s);
  return point(segments_[place.segment], place.t);
}

Vec2 Curve::tangent(double s) const {
  if (empty()) return {1, 0};
  const Place place = locate(segments_, ends_, s);
  return unit_tangent(segments_[place.segment], place.t);
}

double Curve::curvature(double s) const {
  if (empty()) return 0;
  const Place place = locate(segments_, ends_, s);
  return toile::curvature(segments_[place.segment], place.t);
}

Curve Curve::reversed() const {
  std::vector<Segment> backwards = each(segments_, [](const Segment& s) { return toile::reversed(s); });
  std::reverse(backwards.begin(), backwards.end());
  return Curve(std::move(backwards));
}

Curve Curve::part(double s0, double s1) const {
  std::vector<Segment> parts;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const double begin = i > 0 ? ends_[i - 1] : 0;
    const double length = ends_[i] - begin;
    if (s1 <= begin || s0 >= ends_[i]) continue;
    const double t0 = parameter_at(segments_[i], s0 - begin, length);
    const double t1 = parameter_at(segments_[i], s1 - begin, length);
    if (t0 == 0 && t1 == 1) {
      parts.push_back(segments_[i]);
    } else if (t0 < t1) {
      parts.push_back(toile::part(segments_[i], t0, t1));
    }
  }
  if (parts.empty() && !empty()) parts.emplace_back(LineSegment{at(s0), at(s1)});
  return Curve(std::move(parts));
}

Curve Curve::mirrored(Vec2 point, Vec2 axis) const {
  return Curve(each(segments_, [&](const Segment& s) { return toile::mirrored(s, point, axis); }));
}
Curve Curve::moved(Vec2 shift) const {
  return Curve(each(segments_, [&](const Segment& s) { return toile::moved(s, shift); }));
}
Curve Curve::rotated(double angle, Vec2 about) const {
  return Curve(each(segments_, [&](const Segment& s) { return toile::rotated(s, angle, about); }));
}

std::vector<Vec2> Curve::polygon(double chord_error) const {
  std::vector<Vec2> points{start()};
  for (const Segment& segment : segments_) {
    if (const auto* bezier = std::get_if<BezierSegment>(&segment)) {
      follow(*bezier, std::max(chord_error, 1e-12), 0, points);
      continue;
    }
    const auto* arc = std::get_if<ArcSegment>(&segment);
    const int parts = arc == nullptr ? 1 : std::max(1, arc_divisions(*arc, chord_error));
    for (int k = 1; k <= parts; ++k) points.push_back(point(segment, static_cast<double>(k) / parts));
  }
  return points;
}

std::vector<double> Curve::divide(double chord_error, double longest) const {
  std::vector<double> cuts{0};
  if (!(length() > 0) || !std::isfinite(length())) return cuts;
  chord_error = std::max(chord_error, 1e-12);
  longest = std::max(longest, length() / kMostDivisions);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const double begin = i > 0 ? ends_[i - 1] : 0;
    const double own = ends_[i] - begin;
    if (!(own > 0)) continue;
    int parts = std::max(1, static_cast<int>(std::ceil(own / longest - 1e-9)));
    if (const auto* arc = std::get_if<ArcSegment>(&segments_[i])) {
      parts = std::max(parts, arc_divisions(*arc, chord_error));
      for (int k = 1; k <= parts; ++k) cuts.push_back(begin + own * k / parts);
    } else {
      for (int k = 0; k < parts; ++k) {
        divide_stretch(segments_[i], begin, own, own * k / parts, own * (k + 1) / parts, chord_error, 0, cuts);
      }
    }
    cuts.back() = ends_[i];
  }
  cuts.erase(std::unique(cuts.begin(), cuts.end(), [](double a, double b) { return b <= a; }), cuts.end());
  cuts.back() = length();
  return cuts;
}

}  // namespace toile
