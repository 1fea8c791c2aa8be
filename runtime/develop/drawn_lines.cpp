#include "runtime/develop/drawn_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compiler/curve/shape.hpp"
#include "runtime/develop/fit.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr double shortest_line = 1e-5;      // [m]
constexpr double drawing_tolerance = 1e-4;  // [m] of a curve from the line that it stands for
constexpr int stretches = 96;               // of a shortest way
constexpr int most_pulls = 300;
constexpr double still = 1e-8;         // [m] that no point moves by any more
constexpr double finest = 0.002;       // [m] between points of a line in space
constexpr double near_body = 0.03;     // [m] farther off a point is not meant to lie on the body
constexpr double jump = 4;             // times as far in the chart as in space, beside the mean: the chart is cut there
constexpr double on_the_body = 0.001;  // [m] that a body's line may lie off the part that a chart shows

Vec3 in_space(const std::array<double, 3>& p) {
  return {p[0], p[1], p[2]};
}

/// d of -d" = f between ends that are held, points one apart.
std::vector<Vec3> sagged(std::vector<Vec3> f) {
  std::vector<double> pivots(f.size(), 2);
  for (std::size_t i = 1; i < f.size(); ++i) {
    pivots[i] = 2 - 1 / pivots[i - 1];
    f[i] += f[i - 1] / pivots[i - 1];
  }
  for (std::size_t i = f.size(); i-- > 0;) f[i] = (f[i] + (i + 1 < f.size() ? f[i + 1] : Vec3{})) / pivots[i];
  return f;
}

double length_of(const std::vector<Vec3>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

/// The Catmull-Rom spline through points in space, by small steps.
std::vector<Vec3> smooth_line(const std::vector<Vec3>& through) {
  std::vector<Vec3> line;
  const auto at = [&](std::size_t i, int off) {
    const int last = static_cast<int>(through.size()) - 1, k = static_cast<int>(i) + off;
    if (k < 0) return 2 * through.front() - through[1];
    if (k > last) return 2 * through.back() - through[through.size() - 2];
    return through[index(k)];
  };
  for (std::size_t i = 0; i + 1 < through.size(); ++i) {
    const Vec3 a = at(i, -1), b = at(i, 0), c = at(i, 1), d = at(i, 2);
    const int steps = std::clamp(static_cast<int>(std::ceil(distance(b, c) / finest)), 1, 500);
    for (int k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      line.push_back(b + 0.5 * t * ((c - a) + t * ((2 * a - 5 * b + 4 * c - d) + t * (3 * b - a - 3 * c + d))));
    }
  }
  line.push_back(through.back());
  return line;
}

/// A smooth curve within the tolerance of places, its ends exactly where they are.
Curve curve_through(std::vector<Vec2> places) {
  places.erase(std::unique(places.begin(), places.end(), [](Vec2 a, Vec2 b) { return distance(a, b) < 1e-6; }),
               places.end());
  FittedCurve fitted = fit_curve(places, drawing_tolerance);
  fitted.points.front() = places.front();
  fitted.points.back() = places.back();
  if (fitted.straight()) return line(places.front(), places.back());
  return spline(fitted.points, fitted.leaving, fitted.arriving);
}

/// Where the chart shows a line of points; nothing where it loses it.
std::vector<Vec2> shown(const BodyChart& chart, const std::vector<Vec3>& points, Vec2 near) {
  std::vector<Vec2> places;
  for (const Vec3 p : points) {
    const auto place = chart.place_of(p, places.empty() ? near : places.back());
    if (!place) return {};
    places.push_back(*place);
  }
  return places;
}

std::string shown_text(Vec2 place) {
  return fmt::format("({:.1f} cm, {:.1f} cm)", 100 * place.x, 100 * place.y);
}

class Answering {
 public:
  Answering(const ChartQuestion& question, const Body& body, const BodyChart& chart, std::string& error)
      : question_(question), body_(body), chart_(chart), error_(error) {}

  ChartAnswer find() {
    switch (question_.kind) {
      case ChartQuestion::Kind::Place:
        return {place(), {}};
      case ChartQuestion::Kind::Line:
        return {{}, curve_or_error(body_line(), "the map shows nothing of this line")};
      case ChartQuestion::Kind::Geodesic:
        return {{}, curve_or_error(geodesic(), "the shortest way leaves what the map shows")};
      case ChartQuestion::Kind::Drawn:
        return {{}, curve_or_error(drawn(), "the line leaves what the map shows")};
    }
    return {};
  }

 private:
  Curve curve_or_error(const std::vector<Vec2>& places, const char* none) {
    if (error_.empty() && places.size() < 2) error_ = none;
    const bool long_enough =
        std::any_of(places.begin(), places.end(), [&](Vec2 p) { return distance(p, places.front()) > shortest_line; });
    if (error_.empty() && !long_enough) error_ = "the line has no length: its points are one place";
    return error_.empty() ? curve_through(places) : Curve{};
  }

  std::optional<Vec3> foot(const std::array<double, 3>& wanted) {
    const Vec3 p = in_space(wanted);
    const auto found = body_.nearest(p, near_body);
    if (found && std::abs(found->distance) <= near_body) return found->point;
    error_ = fmt::format("({:.1f} cm, {:.1f} cm, {:.1f} cm) lies more than {:.0f} cm off the body", 100 * p.x,
                         100 * p.y, 100 * p.z, 100 * near_body);
    return std::nullopt;
  }

  Vec2 place() {
    const auto point = foot(question_.points.front());
    if (!point) return {};
    const auto found = chart_.place_of(*point);
    if (!found) error_ = "the map does not show this point of the body";
    return found.value_or(Vec2{});
  }

  std::vector<Vec2> geodesic() {
    for (const Vec2 end : {question_.from, question_.to}) {
      if (chart_.at(end).times == 1) continue;
      error_ = fmt::format("at {} the map does not show one place of the body", shown_text(end));
      return {};
    }
    std::vector<Vec2> places = shown(chart_, shortest_way(body_, chart_, question_.from, question_.to), question_.from);
    if (places.empty()) return places;
    places.front() = question_.from;
    places.back() = question_.to;
    return places;
  }

  std::vector<Vec2> drawn() {
    std::vector<Vec3> through;
    for (const auto& wanted : question_.points) {
      const auto point = foot(wanted);
      if (!point) return {};
      through.push_back(*point);
    }
    std::vector<Vec3> points;
    for (const Vec3 p : smooth_line(through)) {
      const auto found = body_.nearest(p, near_body);
      if (found) points.push_back(found->point);
    }
    return shown(chart_, points, {});
  }

  /// A line round the axis of a map that turns goes from behind to behind; else the longest part that the map shows.
  std::vector<Vec2> body_line() {
    const BodyLine* line = body_.line(question_.line);
    if (line == nullptr) {
      error_ = fmt::format("the body has no line `{}`", question_.line);
      return {};
    }
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < line->points.size(); ++i) {
      const Vec3 a = line->points[i], b = line->points[(i + 1) % line->points.size()];
      const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / finest)));
      for (int k = 0; k < steps; ++k) points.push_back(a + (static_cast<double>(k) / steps) * (b - a));
    }
    return chart_.turns() ? round_axis(points) : longest_run(points);
  }

  /// Once round, cut where the map is cut: half a turn from the front.
  std::vector<Vec2> round_axis(const std::vector<Vec3>& points) {
    std::size_t first = 0;
    double least = 1e300;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto here = chart_.place_of(points[i]);
      if (!here || here->x >= least) continue;
      least = here->x;
      first = i;
    }
    // Where it passes behind, between the last of these points and the first.
    Vec3 before = points[(first + points.size() - 1) % points.size()], after = points[first];
    for (int halving = 0; halving < 60; ++halving) {
      const Vec3 middle = 0.5 * (before + after);
      const auto here = chart_.place_of(middle);
      (here && here->x < 0 ? after : before) = middle;
    }
    std::vector<Vec3> rotated{after};
    for (std::size_t i = 0; i < points.size(); ++i) rotated.push_back(points[(first + i) % points.size()]);
    rotated.push_back(after);
    const auto start = chart_.place_of(rotated.front());
    return start ? shown(chart_, rotated, *start) : std::vector<Vec2>{};
  }

  std::vector<Vec2> longest_run(const std::vector<Vec3>& points) {
    std::vector<std::vector<Vec2>> runs(1);
    double step = 0;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i)
      step += distance(points[i], points[(i + 1) % count]) / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto place = chart_.place_of(points[i]);
      const bool here = place && distance(chart_.at(*place).point, points[i]) < on_the_body + chart_.ease();
      const bool breaks = here && !runs.back().empty() && distance(runs.back().back(), *place) > jump * step;
      if ((!here || breaks) && !runs.back().empty()) runs.emplace_back();
      if (here) runs.back().push_back(*place);
    }
    // What was shown up to the end goes on at the beginning.
    if (runs.size() > 1 && !runs.back().empty() && !runs.front().empty() &&
        distance(runs.back().back(), runs.front().front()) < jump * step) {
      runs.back().insert(runs.back().end(), runs.front().begin(), runs.front().end());
      runs.front().clear();
    }
    return *std::max_element(runs.begin(), runs.end(),
                             [](const auto& a, const auto& b) { return a.size() < b.size(); });
  }

  const ChartQuestion& question_;
  const Body& body_;
  const BodyChart& chart_;
  std::string& error_;
};

}  // namespace

/// Points are pulled together and laid on the body again, in turn: what pulls is the part of the pull that lies in the
/// surface, made a displacement of the whole line at once. It ends where the pull is square to the body.
std::vector<Vec3> shortest_way(const Body& body, const BodyChart& chart, Vec2 from, Vec2 to) {
  std::vector<Vec3> points;
  for (int i = 0; i <= stretches; ++i) {
    const double share = static_cast<double>(i) / stretches;
    const BodyChart::Meeting meeting = chart.at((1 - share) * from + share * to);
    if (meeting.times < 1) return {};
    const auto foot = body.nearest(meeting.point, near_body);
    if (!foot) return {};
    points.push_back(foot->point);
  }
  double length = length_of(points), fraction = 1;
  for (int round = 0; round < most_pulls && fraction > 1e-3; ++round) {
    std::vector<Vec3> pull;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const auto foot = body.nearest(points[i], near_body);
      const Vec3 normal = foot ? foot->normal : Vec3{};
      const Vec3 force = points[i - 1] - 2 * points[i] + points[i + 1];
      pull.push_back(force - dot(force, normal) * normal);
    }
    const std::vector<Vec3> way = sagged(pull);
    std::vector<Vec3> moved = points;
    double farthest = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
      const auto foot = body.nearest(points[i + 1] + fraction * way[i], near_body);
      if (!foot) return points;
      moved[i + 1] = foot->point;
      farthest = std::max(farthest, distance(moved[i + 1], points[i + 1]));
    }
    const double now = length_of(moved);
    if (now > length * (1 + 1e-9)) {
      fraction /= 2;
      continue;
    }
    points = std::move(moved);
    length = now;
    if (farthest < still) break;
  }
  return points;
}

ChartAnswer answer(const ChartQuestion& question, const Body& body, const BodyChart& chart, std::string& error) {
  return Answering(question, body, chart, error).find();
}

}  // namespace toile
