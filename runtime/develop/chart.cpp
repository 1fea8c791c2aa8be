#include "runtime/develop/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

constexpr int most_shelves = 400;
constexpr double on_edge = 1e-9;     // how far outside of a triangle, in its own coordinates, still is on it
constexpr double same_place = 1e-7;  // [m] hits nearer than this are one, on the edge of two triangles

Vec3 middle_of_line(const std::vector<Vec3>& closed_line) {
  Vec3 sum;
  double length = 0;
  for (std::size_t i = 0; i < closed_line.size(); ++i) {
    const Vec3 a = closed_line[i], b = closed_line[(i + 1) % closed_line.size()];
    sum += distance(a, b) * 0.5 * (a + b);
    length += distance(a, b);
  }
  return length > 0 ? sum / length : Vec3{};
}

Vec3 middle_of_box(const Body::Surface& surface) {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const Vec3 p : surface.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return 0.5 * (low + high);
}

/// The waist, or else the first line that a garment would hang straight down from; null when there is none.
const BodyLine* level_line(const Body& body) {
  if (const BodyLine* waist = body.line("waist")) return waist;
  for (const BodyLine& line : body.lines()) {
    if (line.axis.z < -0.999) return &line;
  }
  return nullptr;
}

/// The part of `v` square to the unit vector `axis`, made a unit vector; any such when there is none.
Vec3 square_to(Vec3 axis, Vec3 v) {
  for (const Vec3 candidate : {v, Vec3{0, -1, 0}, Vec3{1, 0, 0}}) {
    const Vec3 across = candidate - dot(candidate, axis) * axis;
    if (norm(across) > 1e-6) return normalized(across);
  }
  return {1, 0, 0};
}

Vec3 space_point(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

/// How far along the ray the triangle is met from within, or nothing.
std::optional<double> leaves_through(Vec3 from, Vec3 along, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 normal = cross(ab, ac);
  const double facing = dot(normal, along);
  if (!(facing > 1e-12 * norm(normal))) return std::nullopt;
  const double distance = dot(normal, a - from) / facing;
  if (!(distance > 0)) return std::nullopt;
  const Vec3 p = from + distance * along - a;
  const double square = dot(normal, normal);
  const double second = dot(cross(p, ac), normal) / square, third = dot(cross(ab, p), normal) / square;
  if (second < -on_edge || third < -on_edge || second + third > 1 + on_edge) return std::nullopt;
  return distance;
}

}  // namespace

BodyChart::BodyChart(const Body& body, const ChartSpec& spec, std::string& error) : body_(body), spec_(spec) {
  up_ = {0, 0, 1};
  front_ = {0, -1, 0};
  const BodyLine* line = spec.line.empty() ? nullptr : body.line(spec.line);
  if (!spec.line.empty() && line == nullptr) {
    error = fmt::format("the body has no line `{}`", spec.line);
    return;
  }
  if (line != nullptr) {
    origin_ = middle_of_line(line->points);
    up_ = -line->axis;
    front_ = square_to(up_, line->points.front() - origin_);
  } else {
    const BodyLine* round_it = level_line(body);
    origin_ = round_it != nullptr ? middle_of_line(round_it->points) : middle_of_box(body.surface());
    if (spec.map == ChartSpec::Map::Cylinder) origin_.z = 0;
  }
  if (spec.centre) origin_ = space_point(*spec.centre);
  if (spec.pole) {
    up_ = normalized(space_point(*spec.pole));
    front_ = square_to(up_, front_);
  }
  left_ = cross(up_, front_);
  sort_triangles();
}

double BodyChart::level(Vec2 place) const {
  return spec_.map == ChartSpec::Map::Cylinder ? place.y : norm(place) / spec_.radius;
}

BodyChart::Ray BodyChart::ray(Vec2 place) const {
  if (spec_.map == ChartSpec::Map::Cylinder) {
    const double angle = place.x / spec_.radius;
    return {origin_ + place.y * up_, std::cos(angle) * front_ + std::sin(angle) * left_};
  }
  // Seen from outside with the front below: x to the left of the wearer, y to the back.
  const double off_pole = norm(place) / spec_.radius;
  if (off_pole < 1e-12) return {origin_, up_};
  const Vec3 across = (place.x * left_ - place.y * front_) / norm(place);
  return {origin_, std::cos(off_pole) * up_ + std::sin(off_pole) * across};
}

void BodyChart::sort_triangles() {
  const Body::Surface& surface = body_.surface();
  const bool cylinder = spec_.map == ChartSpec::Map::Cylinder;
  const auto level_of = [&](Vec3 p) {
    const Vec3 from = p - origin_;
    return cylinder ? dot(from, up_) : std::atan2(norm(cross(up_, from)), dot(up_, from));
  };
  std::vector<std::array<double, 2>> ranges;
  double highest = -1e300;
  lowest_ = 1e300;
  for (const std::array<int, 3>& triangle : surface.triangles) {
    std::array<double, 2> range{1e300, -1e300};
    double span = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 p = surface.points[static_cast<std::size_t>(triangle[i])];
      const Vec3 q = surface.points[static_cast<std::size_t>(triangle[(i + 1) % 3])];
      range = {std::min(range[0], level_of(p)), std::max(range[1], level_of(p))};
      // Inside of a triangle the angle strays from its corners' by no more than the triangle spans itself.
      if (!cylinder)
        span = std::max(span, std::atan2(norm(cross(p - origin_, q - origin_)), dot(p - origin_, q - origin_)));
    }
    range = {range[0] - span, range[1] + span};
    ranges.push_back(range);
    lowest_ = std::min(lowest_, range[0]);
    highest = std::max(highest, range[1]);
  }
  step_ = std::max((highest - lowest_) / most_shelves, 1e-9);
  shelves_.resize(most_shelves);
  const auto shelf = [&](double level) {
    return static_cast<std::size_t>(std::clamp(std::floor((level - lowest_) / step_), 0.0, most_shelves - 1.0));
  };
  for (std::size_t t = 0; t < ranges.size(); ++t) {
    for (std::size_t s = shelf(ranges[t][0] - 1e-9); s <= shelf(ranges[t][1] + 1e-9); ++s) {
      shelves_[s].push_back(static_cast<int>(t));
    }
  }
}

BodyChart::Meeting BodyChart::at(Vec2 place) const {
  Meeting meeting;
  const double where = (level(place) - lowest_) / step_;
  const bool within = spec_.map == ChartSpec::Map::Cylinder || norm(place) < std::numbers::pi * spec_.radius;
  if (shelves_.empty() || !(where >= 0) || !(where <= most_shelves) || !within) return meeting;
  const Ray ray = this->ray(place);
  const Body::Surface& surface = body_.surface();
  std::vector<double> hits;
  for (const int t : shelves_[std::min(static_cast<std::size_t>(where), shelves_.size() - 1)]) {
    const std::array<int, 3>& triangle = surface.triangles[static_cast<std::size_t>(t)];
    const auto corner = [&](std::size_t i) { return surface.points[static_cast<std::size_t>(triangle[i])]; };
    const auto hit = leaves_through(ray.from, ray.along, corner(0), corner(1), corner(2));
    if (hit) hits.push_back(*hit);
  }
  std::sort(hits.begin(), hits.end());
  hits.erase(std::unique(hits.begin(), hits.end(), [](double a, double b) { return b - a < same_place; }), hits.end());
  meeting.times = static_cast<int>(hits.size());
  if (hits.empty()) return meeting;
  meeting.point = ray.from + hits.front() * ray.along;
  if (spec_.ease > 0) {
    if (const auto surface_point = body_.nearest(meeting.point, 1e-3)) {
      meeting.point += spec_.ease * surface_point->normal;
    }
  }
  return meeting;
}

}  // namespace toile
