#include "compiler/pmesh/refinement_rules.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/pmesh/sides.hpp"

namespace toile {
namespace {

using std::numbers::pi;
constexpr double kLeastAngle = 27 * pi / 180;   // triangles with a smaller angle are refined
constexpr double kAcuteCorner = 61 * pi / 180;  // corners that need shells
constexpr double kNarrow = 0.2;                 // of an edge
constexpr double kFirstShell = 0.25;            // of an edge: shells about acute corners are no smaller
constexpr double kCircumradiusPerEdge = 0.74;   // measured: the mean edge then comes to the length asked for
constexpr double kLensCosine = -0.5;

double angle_at(Vec2 apex, Vec2 a, Vec2 b) {
  return std::atan2(std::abs(cross(a - apex, b - apex)), dot(a - apex, b - apex));
}

}  // namespace

RefinementRules::RefinementRules(const PlaneDomain& domain, const TriangulationSize& size) : size_(size) {
  for (const auto& nodes : domain.loops) {
    const std::size_t n = nodes.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 before = nodes[(i + n - 1) % n], at = nodes[i], after = nodes[(i + 1) % n];
      const double angle = angle_at(at, before, after);
      if (cross(at - before, after - at) > 0 && angle < kAcuteCorner) acute_.push_back({at, angle});
    }
  }
  add_corners_of_lines(domain);
}

/// Between the sides that meet at a node of a line, those of the outline among them.
void RefinementRules::add_corners_of_lines(const PlaneDomain& domain) {
  if (domain.lines.empty()) return;
  const std::vector<Vec2> nodes = nodes_of(domain);
  std::vector<bool> on_line(nodes.size(), false);
  for (const auto& line : domain.lines) {
    for (const int node : line) on_line[node] = true;
  }
  std::vector<std::vector<double>> directions(nodes.size());
  for (const auto& [loop, from, a, b] : sides_of(domain)) {
    const Vec2 way = nodes[b] - nodes[a];
    if (on_line[a]) directions[a].push_back(std::atan2(way.y, way.x));
    if (on_line[b]) directions[b].push_back(std::atan2(-way.y, -way.x));
  }
  for (std::size_t v = 0; v < nodes.size(); ++v) {
    std::vector<double>& all = directions[v];
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size() && all.size() > 1; ++i) {
      const double angle = i + 1 < all.size() ? all[i + 1] - all[i] : all[0] + 2 * pi - all[i];
      if (angle < kAcuteCorner) acute_.push_back({nodes[v], angle});
    }
  }
}

double RefinementRules::edge_at(Vec2 p) const {
  double edge = size_.edge;
  for (const SizeSpot& spot : size_.spots) {
    if (spot.edge < edge && distance(p, spot.centre) <= spot.radius) edge = spot.edge;
  }
  return edge;
}

double RefinementRules::urgency(const std::array<Vec2, 3>& p) const {
  std::array<double, 3> l{};
  for (int i = 0; i < 3; ++i) l[i] = distance(p[(i + 1) % 3], p[(i + 2) % 3]);
  const int least = static_cast<int>(std::min_element(l.begin(), l.end()) - l.begin());
  const Vec2 a = p[(least + 1) % 3], b = p[(least + 2) % 3];
  const double twice_area = std::abs(cross(p[1] - p[0], p[2] - p[0]));
  const double radius = l[0] * l[1] * l[2] / std::max(2 * twice_area, 1e-300);
  const double oversize = radius / (kCircumradiusPerEdge * edge_at((p[0] + p[1] + p[2]) / 3));
  if (oversize > 1) return 1 + std::min(oversize, 1e6);
  const double sine = twice_area / (l[(least + 1) % 3] * l[(least + 2) % 3]);
  if (sine >= std::sin(kLeastAngle) || l[least] < size_.shortest || excused(p[least], a, b)) return 0;
  return 1 - sine;
}

/// The smallest angle, at `apex`, is the script's own, or the two nodes facing it lie on the two sides of an acute
/// corner at the same distance, where the piece is narrow.
bool RefinementRules::excused(Vec2 apex, Vec2 a, Vec2 b) const {
  const bool narrow = distance(a, b) < kNarrow * size_.edge;
  return std::any_of(acute_.begin(), acute_.end(), [&](const Corner& corner) {
    if (corner.at == apex) return true;
    const double ra = distance(a, corner.at), rb = distance(b, corner.at);
    return narrow && std::abs(ra - rb) < 0.05 * (ra + rb) &&
           std::abs(angle_at(corner.at, a, b) - corner.angle) < 0.1 * corner.angle;
  });
}

bool RefinementRules::acute_at(Vec2 p) const {
  return std::any_of(acute_.begin(), acute_.end(), [&](const Corner& corner) { return corner.at == p; });
}

std::optional<double> RefinementRules::place_of_split(Vec2 p, Vec2 q) const {
  const double length = distance(p, q);
  const bool at_p = acute_at(p), at_q = acute_at(q);
  if (length < 2 * size_.shortest) return std::nullopt;
  if ((at_p || at_q) && length < 2 * kFirstShell * edge_at((p + q) / 2)) return std::nullopt;
  if (at_p == at_q) return 0.5;
  const double shell = std::exp2(std::round(std::log2(length / 2)));
  const double lambda = std::clamp(shell / length, 0.25, 0.75);
  return at_p ? lambda : 1 - lambda;
}

bool RefinementRules::encroaches(Vec2 p, Vec2 a, Vec2 b) {
  return dot(a - p, b - p) < kLensCosine * norm(a - p) * norm(b - p);
}

long RefinementRules::most_nodes(double area, std::size_t given) const {
  const double radius = kCircumradiusPerEdge * size_.edge;
  return 1000 + 50 * static_cast<long>(given) + static_cast<long>(std::min(1e7, 8 * area / (radius * radius)));
}

}  // namespace toile
