// Cubic splines: the slopes at the points follow from one linear system, three terms a row.
#include <cmath>

#include "compiler/curve/shape.hpp"

namespace toile {
namespace {

/// before * x[i-1] + own * x[i] + after * x[i+1] = right
struct SplineRow {
  double before = 0, own = 0, after = 0;
  Vec2 right;
};

std::vector<Vec2> solve_rows(std::vector<SplineRow> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double factor = rows[i].before / rows[i - 1].own;
    rows[i].own -= factor * rows[i - 1].after;
    rows[i].right = rows[i].right - factor * rows[i - 1].right;
  }
  std::vector<Vec2> x(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;) {
    const Vec2 rest = i + 1 < rows.size() ? rows[i].right - rows[i].after * x[i + 1] : rows[i].right;
    x[i] = rest / rows[i].own;
  }
  return x;
}

/// The same where the first row's `before` means the last unknown and the last row's `after` the first: by Sherman and
/// Morrison's formula.
std::vector<Vec2> solve_ring(std::vector<SplineRow> rows) {
  const double corner = rows.front().before, other = rows.back().after;
  const double gamma = -rows.front().own;
  std::vector<SplineRow> spare = rows;
  for (auto* system : {&rows, &spare}) {
    system->front().own -= gamma;
    system->back().own -= corner * other / gamma;
  }
  for (SplineRow& row : spare) row.right = {};
  spare.front().right.x = gamma;
  spare.back().right.x = other;
  const std::vector<Vec2> x = solve_rows(rows), z = solve_rows(spare);
  const double scale = 1 + z.front().x + corner * z.back().x / gamma;
  const Vec2 share = (x.front() + corner / gamma * x.back()) / scale;
  std::vector<Vec2> sum;
  for (std::size_t i = 0; i < x.size(); ++i) sum.push_back(x[i] - z[i].x * share);
  return sum;
}

/// The curvature runs on at a point between two chords.
SplineRow smooth_row(Vec2 before, Vec2 point, Vec2 after) {
  const double a = distance(before, point), b = distance(point, after);
  return {b, 2 * (a + b), a, 3 * (b / a * (point - before) + a / b * (after - point))};
}

Curve through(const std::vector<Vec2>& points, const std::vector<Vec2>& slopes) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double third = distance(points[i], points[i + 1]) / 3;
    segments.emplace_back(
        BezierSegment{points[i], points[i] + third * slopes[i], points[i + 1] - third * slopes[i + 1], points[i + 1]});
  }
  return Curve(std::move(segments));
}

}  // namespace

Curve spline(const std::vector<Vec2>& points, std::optional<double> leaving, std::optional<double> arriving) {
  const std::size_t last = points.size() - 1;
  const auto end_row = [](const std::optional<double>& angle, Vec2 from, Vec2 to) {
    if (angle) return SplineRow{0, 1, 0, direction(*angle)};
    return SplineRow{1, 2, 1, 3 / distance(from, to) * (to - from)};
  };
  std::vector<SplineRow> rows{end_row(leaving, points[0], points[1])};
  rows.front().before = 0;
  for (std::size_t i = 1; i < last; ++i) rows.push_back(smooth_row(points[i - 1], points[i], points[i + 1]));
  rows.push_back(end_row(arriving, points[last - 1], points[last]));
  rows.back().after = 0;
  return through(points, solve_rows(std::move(rows)));
}

Curve closed_spline(const std::vector<Vec2>& points) {
  const std::size_t n = points.size();
  std::vector<SplineRow> rows;
  for (std::size_t i = 0; i < n; ++i)
    rows.push_back(smooth_row(points[(i + n - 1) % n], points[i], points[(i + 1) % n]));
  std::vector<Vec2> slopes = solve_ring(std::move(rows));
  std::vector<Vec2> round = points;
  round.push_back(points.front());
  slopes.push_back(slopes.front());
  return through(round, slopes);
}

}  // namespace toile
