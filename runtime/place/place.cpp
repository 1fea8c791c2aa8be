#include "runtime/place/place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/place/arranged.hpp"
#include "runtime/place/layout.hpp"
#include "runtime/place/outside.hpp"
#include "runtime/place/rest_mesh.hpp"
#include "runtime/place/sewn_upon.hpp"
#include "runtime/place/worn_component.hpp"

namespace toile {
namespace {

constexpr double gap = 0.002;      // [m] between a cloth laid flat and what is below it
constexpr double layer_gap = 0.2;  // of the mean edge, between garments worn over each other

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

std::string no_such_line(const std::string& name, const Body& body) {
  if (body.lines().empty()) return fmt::format("the body {} has no lines, and so no `{}`", body.spec().name, name);
  std::vector<std::string> names;
  for (const BodyLine& line : body.lines()) names.push_back(line.name);
  const auto nearest = std::min_element(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(a, name) < edit_distance(b, name);
  });
  const bool is_near = edit_distance(*nearest, name) <= std::max<std::size_t>(2, name.size() / 3);
  return fmt::format("the body {} has no line `{}`{}; its lines are {}", body.spec().name, name,
                     is_near ? fmt::format(" (did you mean `{}`?)", *nearest) : "", fmt::join(names, ", "));
}

std::string worn_fault(const std::vector<Worn>& worn, const Body* body) {
  for (const Worn& w : worn) {
    if (w.line == nullptr || w.line->vertices.size() < 2) return fmt::format("nothing is worn at `{}`", w.body_line);
    if (body == nullptr) return fmt::format("without a body there is no line `{}` to wear a garment at", w.body_line);
    if (body->line(w.body_line) == nullptr) return no_such_line(w.body_line, *body);
  }
  return {};
}

std::vector<std::vector<int>> components_of(const SMesh& mesh) {
  int count = 0;
  for (const int c : mesh.component_of_vertex) count = std::max(count, c + 1);
  std::vector<std::vector<int>> members(static_cast<std::size_t>(count));
  for (int v = 0; v < mesh.vertex_count; ++v) members[mesh.component_of_vertex[v]].push_back(v);
  return members;
}

// One piece with nothing sewn: it lies flat as it is drawn.
bool is_plain(const SewnMesh& mesh, const std::vector<int>& members) {
  const PieceId piece = mesh.p.piece_of_point[mesh.s.p_of_s[members.front()].front()];
  return std::all_of(members.begin(), members.end(), [&](int v) {
    const auto& corners = mesh.s.p_of_s[v];
    return corners.size() == 1 && mesh.p.piece_of_point[corners.front()] == piece;
  });
}

void lay_flat(const SewnMesh& mesh, const std::vector<int>& members, std::vector<Vec3>& positions) {
  for (const int v : members) {
    const Vec2 p = mesh.p.points[mesh.s.p_of_s[v].front()];
    positions[v] = {p.x, p.y, 0};
  }
}

Vec3 centre_of_area(const Cloth& cloth, const std::vector<int>& members, const std::vector<Vec3>& positions) {
  Vec3 sum;
  double area = 0;
  for (const int v : members) {
    sum += cloth.area_of_vertex[v] * positions[v];
    area += cloth.area_of_vertex[v];
  }
  return area > 0 ? sum / area : positions[members.front()];
}

struct Extent {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};

Extent extent_of(const std::vector<int>& members, const std::vector<Vec3>& positions) {
  Extent extent;
  for (const int v : members) {
    const Vec3 p = positions[v];
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y), std::min(extent.low.z, p.z)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y), std::max(extent.high.z, p.z)};
  }
  return extent;
}

void shift(const std::vector<int>& members, Vec3 by, std::vector<Vec3>& positions) {
  for (const int v : members) positions[v] += by;
}

// Components that hang from nothing: above the body one over another, or without a body side by side.
class LoosePieces {
 public:
  LoosePieces(const Cloth& cloth, const Body* body)
      : cloth_(cloth), on_body_(body != nullptr), top_(on_body_ ? body->top() : Vec3{}) {}

  void add(const std::vector<int>& members, std::vector<Vec3>& positions) {
    const Extent extent = extent_of(members, positions);
    if (on_body_) {
      const Vec3 centre = centre_of_area(cloth_, members, positions);
      shift(members, {top_.x - centre.x, top_.y - centre.y, top_.z + gap - extent.low.z}, positions);
      top_.z += gap + extent.high.z - extent.low.z;
      return;
    }
    if (!is_first_) shift(members, {right_ + 0.05 - extent.low.x, 0, 0}, positions);
    right_ = extent_of(members, positions).high.x;
    is_first_ = false;
  }

 private:
  const Cloth& cloth_;
  bool on_body_;
  Vec3 top_;
  bool is_first_ = true;
  double right_ = 0;
};

// Last of all: every position finite, no two the same.
void keep_apart(std::vector<Vec3>& positions) {
  constexpr double least = 1e-6;  // [m]
  for (Vec3& p : positions) {
    if (!std::isfinite(p.x + p.y + p.z)) p = {};
  }
  std::vector<int> order(positions.size());
  for (int pass = 0; pass < 8; ++pass) {
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      const double x = positions[a].x, y = positions[b].x;
      return x < y || (x == y && a < b);
    });
    bool moved = false;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size() && positions[order[j]].x - positions[order[i]].x < least; ++j) {
        if (distance(positions[order[i]], positions[order[j]]) >= least) continue;
        const int later = std::max(order[i], order[j]);
        const double angle = 2.399963 * later;  // the golden angle: neighbours in number go different ways
        positions[later] += 1e-4 * (1 + pass) * Vec3{std::cos(angle), std::sin(angle), std::cos(3 * angle)};
        moved = true;
      }
    }
    if (!moved) return;
  }
}

}  // namespace

Placed place(const SewnMesh& mesh, const Cloth& cloth, const std::vector<Worn>& worn,
             const std::vector<ArrangedPiece>& arranged, const Body* body) {
  Placed placed;
  placed.error = worn_fault(worn, body);
  placed.positions.resize(static_cast<std::size_t>(mesh.s.vertex_count));
  if (!placed.error.empty()) return placed;

  const RestMesh rest(cloth);
  const PleatFolds folds(mesh);
  LoosePieces loose(cloth, body);
  for (const std::vector<int>& members : components_of(mesh.s)) {
    if (members.empty()) continue;
    const int component = mesh.s.component_of_vertex[members.front()];
    std::vector<HungLine> hung;
    for (const Worn& w : worn) {
      if (mesh.s.component_of_vertex[w.line->vertices.front()] != component) continue;
      const BodyLine* line = body->line(w.body_line);
      hung.push_back({line, hang(mesh, w, *line)});
    }
    if (is_arranged(mesh, members, arranged)) {
      place_arranged(mesh, rest, members, arranged, hung, body, placed.positions);
      continue;
    }
    if (!hung.empty()) {
      place_worn(rest, folds, members, std::move(hung), *body, placed.positions);
      continue;
    }
    if (is_plain(mesh, members))
      lay_flat(mesh, members, placed.positions);
    else
      lay_out(rest, members, placed.positions);
    loose.add(members, placed.positions);
  }
  if (body != nullptr) put_outside(rest, *body, std::max(gap, layer_gap * rest.mean_edge()), placed.positions);
  lay_upon(mesh, placed.positions);
  keep_apart(placed.positions);
  for (const Worn& w : worn) {
    if (w.held) placed.held.insert(placed.held.end(), w.line->vertices.begin(), w.line->vertices.end());
  }
  std::sort(placed.held.begin(), placed.held.end());
  placed.held.erase(std::unique(placed.held.begin(), placed.held.end()), placed.held.end());
  return placed;
}

}  // namespace toile
