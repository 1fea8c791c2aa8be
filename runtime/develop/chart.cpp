#include "runtime/develop/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/develop/conformal.hpp"

namespace toile {
namespace {

constexpr int most_shelves = 400;
constexpr double level_pole = 0.7;     // height of a unit vector below which a dome is looked at from the side
constexpr double on_edge = 1e-9;       // how far outside of a triangle, in its own coordinates, still is on it
constexpr double same_place = 1e-7;    // [m] hits nearer than this are one, on the edge of two triangles
constexpr double level_axis = 0.95;    // part of a unit vector that is upright from which an axis has no underside
constexpr double off_the_body = 0.02;  // [m] that a point may lie off the patch that shows it

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
  if (spec.map == ChartSpec::Map::Cone && spec.radius <= 0) {
    spec_.radius = line != nullptr ? line->girth / (2 * std::numbers::pi) : ChartSpec{}.radius;
  }
  if (spec.map == ChartSpec::Map::Conformal) {
    lay_patch(line, error);
    return;
  }
  if (spec.centre) origin_ = space_point(*spec.centre);
  if (spec.pole) {
    up_ = normalized(space_point(*spec.pole));
    front_ = square_to(up_, std::abs(up_.z) < level_pole ? Vec3{0, 0, -1} : front_);
  }
  left_ = cross(up_, front_);
  sort_triangles();
}

/// A patch about a point is seen with what is higher on the body above; where the body lies level, with the back
/// above. A limb's is cut open along its underside, of an upright one along the back, and lies with its line across.
void BodyChart::lay_patch(const BodyLine* line, std::string& error) {
  std::optional<Patch> patch;
  ConformalMap::Seat seat;
  if (line != nullptr) {
    left_ = cross(up_, front_);
    Vec3 open = std::abs(up_.z) < level_axis ? square_to(up_, {0, 0, -1}) : -front_;
    if (spec_.cut) open = std::cos(*spec_.cut) * front_ + std::sin(*spec_.cut) * left_;
    seat.origin = *std::min_element(line->points.begin(), line->points.end(), [&](Vec3 a, Vec3 b) {
      return dot(normalized(square_to(up_, a - origin_)), open) < dot(normalized(square_to(up_, b - origin_)), open);
    });
    seat.up = up_;
    patch = patch_of_limb(body_.surface(), *line, origin_, open, spec_.reach, error);
  } else {
    seat.origin = spec_.centre ? space_point(*spec_.centre) : origin_;
    patch = patch_round(body_.surface(), seat.origin, spec_.reach, error);
    const auto surface = body_.nearest(seat.origin, spec_.reach);
    seat.up = surface && std::abs(surface->normal.z) > level_pole ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  }
  if (!patch) return;
  conformal_ = std::make_shared<const ConformalMap>(std::move(*patch), seat, error);
  if (!error.empty()) conformal_.reset();
}

/// On the unrolled cone a place lies about the tip, which is its side's length away from the line.
BodyChart::AboutAxis BodyChart::about_axis(Vec2 place) const {
  if (spec_.map == ChartSpec::Map::Cylinder) return {place.x / spec_.radius, place.y};
  const double slope = std::sin(std::abs(spec_.angle)), towards_tip = spec_.angle > 0 ? 1 : -1;
  const double side = spec_.radius / slope, below_tip = side - towards_tip * place.y;
  return {std::atan2(place.x, below_tip) / slope,
          towards_tip * (side - std::hypot(place.x, below_tip)) * std::cos(spec_.angle)};
}

Vec2 BodyChart::drawn(AboutAxis place) const {
  if (spec_.map == ChartSpec::Map::Cylinder) return {spec_.radius * place.angle, place.height};
  const double slope = std::sin(std::abs(spec_.angle)), towards_tip = spec_.angle > 0 ? 1 : -1;
  const double side = spec_.radius / slope;
  const double from_tip = side - towards_tip * place.height / std::cos(spec_.angle);
  return {from_tip * std::sin(slope * place.angle), towards_tip * (side - from_tip * std::cos(slope * place.angle))};
}

std::optional<Vec2> BodyChart::place_of(Vec3 point, Vec2 near) const {
  if (spec_.map == ChartSpec::Map::Conformal) {
    return conformal_ != nullptr ? conformal_->place_of(point, off_the_body) : std::nullopt;
  }
  const Vec3 from = point - origin_;
  const Vec2 across{dot(from, left_), dot(from, front_)};  // of the direction to the front, and to the left of it
  if (turns()) {
    const double angle = std::atan2(across.x, across.y), wanted = about_axis(near).angle;
    const double turn = 2 * std::numbers::pi;
    return drawn({angle + turn * std::round((wanted - angle) / turn), dot(from, up_)});
  }
  const double off_pole = std::atan2(norm(across), dot(from, up_));
  if (norm(across) < 1e-12) return Vec2{0, 0};
  return spec_.radius * off_pole / norm(across) * Vec2{across.x, -across.y};
}

double BodyChart::level(Vec2 place) const {
  return turns() ? about_axis(place).height : norm(place) / spec_.radius;
}

BodyChart::Ray BodyChart::ray(Vec2 place) const {
  if (turns()) {
    const AboutAxis at = about_axis(place);
    return {origin_ + at.height * up_, std::cos(at.angle) * front_ + std::sin(at.angle) * left_};
  }
  // Seen from outside with the front below: x to the left of the wearer, y to the back.
  const double off_pole = norm(place) / spec_.radius;
  if (off_pole < 1e-12) return {origin_, up_};
  const Vec3 across = (place.x * left_ - place.y * front_) / norm(place);
  return {origin_, std::cos(off_pole) * up_ + std::sin(off_pole) * across};
}

void BodyChart::sort_triangles() {
  const Body::Surface& surface = body_.surface();
  const bool cylinder = turns();
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
  if (spec_.map == ChartSpec::Map::Conformal) return on_patch(place);
  Meeting meeting;
  const double where = (level(place) - lowest_) / step_;
  const bool within = turns() || norm(place) < std::numbers::pi * spec_.radius;
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
  meeting.point = eased(ray.from + hits.front() * ray.along);
  return meeting;
}

BodyChart::Meeting BodyChart::on_patch(Vec2 place) const {
  Meeting meeting;
  if (conformal_ == nullptr) return meeting;
  std::vector<Vec3> found = conformal_->at(place);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool again = std::any_of(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(i),
                                   [&](Vec3 other) { return distance(other, found[i]) < same_place; });
    if (!again) ++meeting.times;
  }
  if (!found.empty()) meeting.point = eased(found.front());
  return meeting;
}

Vec3 BodyChart::eased(Vec3 point) const {
  if (!(spec_.ease > 0)) return point;
  const auto surface_point = body_.nearest(point, 1e-3);
  return surface_point ? point + spec_.ease * surface_point->normal : point;
}

}  // namespace toile
