#include "runtime/place/pleat_folds.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/place/winding.hpp"

namespace toile {
namespace {

constexpr double on_line = 1e-5;  // [m]

struct CreaseLine {
  PieceId piece = 0;
  bool ridge = false;
  LineSegment line;
};

bool lies_on(const LineSegment& line, Vec2 p) {
  const Vec2 way = line.to - line.from;
  return std::abs(cross(way, p - line.from)) < on_line * norm(way);
}

void stretch_to(LineSegment& line, Vec2 p) {
  const Vec2 way = line.to - line.from;
  const double s = dot(p - line.from, way) / dot(way, way);
  if (s < 0) line.from = p;
  if (s > 1) line.to = p;
}

// Creased edges of a piece that lie on one line, as that line.
std::vector<CreaseLine> crease_lines(const SewnMesh& mesh) {
  std::vector<CreaseLine> lines;
  for (const SMesh::Edge& edge : mesh.s.edges) {
    if (edge.crease == 0) continue;
    const SMesh::Wing& wing = edge.wings.front();
    const auto& t = mesh.p.triangles[wing.triangle];
    const Vec2 a = mesh.p.points[t[(wing.corner + 1) % 3]], b = mesh.p.points[t[(wing.corner + 2) % 3]];
    const PieceId piece = mesh.p.piece_of_triangle[wing.triangle];
    const auto same = std::find_if(lines.begin(), lines.end(), [&](const CreaseLine& known) {
      return known.piece == piece && known.ridge == (edge.crease > 0) && lies_on(known.line, a) &&
             lies_on(known.line, b);
    });
    if (same == lines.end()) {
      lines.push_back({piece, edge.crease > 0, {a, b}});
      continue;
    }
    stretch_to(same->line, a);
    stretch_to(same->line, b);
  }
  return lines;
}

double apart(const LineSegment& a, const LineSegment& b) {
  return 0.5 * (distance(a.from, b.from) + distance(a.to, b.to));
}

// The valley that belongs to a ridge: pleats keep so far apart that it is the nearest.
std::optional<LineSegment> valley_of(const CreaseLine& ridge, const std::vector<CreaseLine>& lines) {
  std::optional<LineSegment> nearest;
  for (const CreaseLine& line : lines) {
    if (line.piece != ridge.piece || line.ridge) continue;
    LineSegment valley = line.line;
    if (dot(valley.to - valley.from, ridge.line.to - ridge.line.from) < 0) std::swap(valley.from, valley.to);
    if (!nearest || apart(valley, ridge.line) < apart(*nearest, ridge.line)) nearest = valley;
  }
  return nearest;
}

}  // namespace

double PleatFolds::Strip::across(Vec2 p, double& width) const {
  const Vec2 way = ridge.to - ridge.from;
  const double s = std::clamp(dot(p - ridge.from, way) / dot(way, way), 0.0, 1.0);
  const Vec2 from = ridge.from + s * way, to = valley.from + s * (valley.to - valley.from);
  width = std::max(distance(from, to), 1e-6);
  return dot(p - from, to - from) / width;
}

PleatFolds::PleatFolds(const SewnMesh& mesh)
    : mesh_(mesh), layers_(static_cast<std::size_t>(mesh.s.vertex_count), 0.0) {
  const std::vector<CreaseLine> lines = crease_lines(mesh);
  for (const CreaseLine& line : lines) {
    if (!line.ridge) continue;
    if (const auto valley = valley_of(line, lines)) strips_.push_back({line.piece, line.line, *valley});
  }
  // Before the ridge two layers lie below; from there to the valley, and on to where the fold lies, ever fewer.
  for (int v = 0; v < mesh.s.vertex_count; ++v) {
    const std::vector<int>& points = mesh.s.p_of_s[v];
    if (points.size() != 1) continue;
    for (const Strip& strip : strips_) {
      if (strip.piece != mesh.p.piece_of_point[points.front()]) continue;
      double width = 0;
      const double x = strip.across(mesh.p.points[points.front()], width) / width;
      if (x > -1.2 && x < 2) layers_[v] = std::max(layers_[v], x < 0 ? 2 : 2 - x);
    }
  }
}

// Whether the fractions grow from the ridge to the valley (1) or fall (-1).
double PleatFolds::way_round(const Cloth& cloth, const Strip& strip, const std::vector<double>& fraction) const {
  double sum = 0;
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    if (mesh_.p.piece_of_triangle[t] != strip.piece) continue;
    const auto& corners = mesh_.p.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      double width = 0;
      const double a = strip.across(mesh_.p.points[corners[i]], width),
                   b = strip.across(mesh_.p.points[corners[j]], width);
      const bool inside = a > -1e-6 && b > -1e-6 && a < width + 1e-6 && b < width + 1e-6;
      const auto& vertices = cloth.triangles[t].vertices;
      if (inside) sum += (b - a) * turn_between(fraction[vertices[i]], fraction[vertices[j]]);
    }
  }
  return sum < 0 ? -1 : 1;
}

void PleatFolds::fold(const RestMesh& rest, const HangingChain& chain, const std::vector<bool>& in_component,
                      std::vector<double>& fraction) const {
  if (empty()) return;
  const Cloth& cloth = rest.cloth();
  std::vector<double> ways;
  for (const Strip& strip : strips_) ways.push_back(way_round(cloth, strip, fraction));
  // Where the cloth is turned back each length of it winds back by itself instead of on: twice itself less.
  const double turn = chain.curve.length();
  const auto taken_back = [&](PieceId piece, Vec2 p) {
    double sum = 0;
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      if (strips_[i].piece != piece) continue;
      double width = 0;
      const double x = strips_[i].across(p, width);
      sum -= ways[i] * 2 * std::clamp(x, 0.0, width) / turn;
    }
    return sum;
  };
  std::vector<double> back(mesh_.p.points.size());
  for (std::size_t p = 0; p < back.size(); ++p) back[p] = taken_back(mesh_.p.piece_of_point[p], mesh_.p.points[p]);
  std::vector<bool> unknown = in_component;
  for (const int v : chain.vertices) unknown[v] = false;

  std::vector<std::vector<std::pair<int, double>>> wanted(static_cast<std::size_t>(mesh_.s.vertex_count));
  for (const SMesh::Edge& edge : cloth.edges) {
    const auto [v, w] = edge.vertices;
    double sum = 0;
    for (const SMesh::Wing& wing : edge.wings) {
      const std::size_t i = (wing.corner + 1) % 3, j = (wing.corner + 2) % 3;
      const auto& corners = mesh_.p.triangles[wing.triangle];
      const bool same_way = cloth.triangles[wing.triangle].vertices[i] == v;
      const double difference = back[corners[j]] - back[corners[i]];
      sum += same_way ? difference : -difference;
    }
    const double mean = sum / static_cast<double>(edge.wings.size());
    wanted[v].emplace_back(w, mean);
    wanted[w].emplace_back(v, -mean);
  }
  const std::vector<double> added =
      harmonic_correction(cloth, unknown, std::vector<double>(unknown.size(), 0.0), [&](int v, int w) {
        double target = 0;
        for (const auto& [other, value] : wanted[v]) {
          if (other == w) target = value;
        }
        return turn_between(fraction[v], fraction[w]) - target;
      });
  for (std::size_t v = 0; v < added.size(); ++v) fraction[v] += added[v];
}

}  // namespace toile
