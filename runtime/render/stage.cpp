#include "runtime/render/stage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr double kDeepestDip = 5e-3;                         // [m] cloth deeper in the body is shown where it is
constexpr double kClothCrease = std::numbers::pi;            // a cloth is smooth wherever it goes on
constexpr double kBodyCrease = 62 * std::numbers::pi / 180;  // the rim of a disc is an edge
constexpr Rgb kIvory{0.64, 0.60, 0.53};

bool is_finite(Vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

struct Box {
  Vec3 low{INFINITY, INFINITY, INFINITY};
  Vec3 high{-INFINITY, -INFINITY, -INFINITY};

  void add(Vec3 p) {
    if (!is_finite(p)) return;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool empty() const { return low.x > high.x; }
  double diagonal() const { return empty() ? 0 : norm(high - low); }
};

bool is_plane(const Body* body) {
  return body != nullptr && std::holds_alternative<PlaneSpec>(body->spec().shape);
}

/// The points drawn of a cloth: none where its positions do not fit it.
bool fits(const DressedCloth& cloth) {
  return cloth.cloth != nullptr && cloth.positions != nullptr &&
         cloth.positions->size() >= index(cloth.cloth->vertex_count);
}

/// The distances of a triangle's corners to those of its sides that are sewn: linear over the triangle.
PerCorner<Vec3> seam_distances(const Cloth& cloth, const ClothTriangle& triangle) {
  PerCorner<Vec3> result{};
  const auto distance_of = [&](std::size_t corner, std::size_t side) {
    const std::size_t edge = index(triangle.edges[side]);
    if (edge >= cloth.edges.size() || cloth.edges[edge].seam < 0) return kNoSeam;
    if (corner != side) return 0.0;
    const Vec2 base = triangle.uv[(side + 2) % 3] - triangle.uv[(side + 1) % 3];
    const double twice_area = std::abs(cross(base, triangle.uv[side] - triangle.uv[(side + 1) % 3]));
    return norm(base) > 0 ? twice_area / norm(base) : kNoSeam;
  };
  for (std::size_t c = 0; c < 3; ++c) result[c] = {distance_of(c, 0), distance_of(c, 1), distance_of(c, 2)};
  return result;
}

/// One scale for all cloths that show the same field.
std::optional<FieldScale> common_scale(const std::vector<DressedCloth>& cloths, const Field& field) {
  std::vector<double> values;
  std::vector<double> areas;
  for (const DressedCloth& cloth : cloths) {
    if (!fits(cloth) || !cloth.shown || cloth.shown->name != field.name) continue;
    std::vector<double> own = at_vertices(*cloth.shown, *cloth.cloth);
    own.resize(index(cloth.cloth->vertex_count), 0.0);
    std::vector<double> weight = cloth.cloth->area_of_vertex;
    weight.resize(own.size(), 0.0);
    values.insert(values.end(), own.begin(), own.end());
    areas.insert(areas.end(), weight.begin(), weight.end());
  }
  return FieldScale(field, values, areas);
}

/// As finely as a picture needs, without dividing what is fine enough.
Surface smoothed(Surface surface) {
  constexpr std::size_t kEnough = 80'000;
  for (int level = 0; level < 2 && 4 * surface.triangles.size() <= kEnough; ++level) {
    surface = divided(surface, kClothCrease);
  }
  return surface;
}

}  // namespace

Stage::Stage(const std::vector<DressedCloth>& cloths, const Body* body) {
  bring_to_unit_size(cloths, body);
  for (const DressedCloth& cloth : cloths) {
    if (!fits(cloth)) continue;
    add_cloth(cloth, cloth.shown ? common_scale(cloths, *cloth.shown) : std::nullopt, body);
  }
  if (body != nullptr && !is_plane(body)) add_body(*body);
  set_floor(body);
  for (const Actor& actor : actors_) rays_.add(actor.surface.points, actor.surface.triangles);
  rays_.commit();
}

const FieldScale* Stage::scale() const {
  for (const Actor& actor : actors_) {
    if (actor.scale) return &*actor.scale;
  }
  return nullptr;
}

void Stage::bring_to_unit_size(const std::vector<DressedCloth>& cloths, const Body* body) {
  Box box;
  for (const DressedCloth& cloth : cloths) {
    if (!fits(cloth)) continue;
    for (const Vec3& p : *cloth.positions) box.add(p);
  }
  if (body != nullptr && !is_plane(body)) {
    Box all = box;
    for (const Vec3& p : body->surface().points) all.add(p);
    // A small cloth on something vast is the subject by itself.
    constexpr double kVast = 8;
    if (box.empty() || all.diagonal() < kVast * box.diagonal()) box = all;
  }
  if (box.empty()) return;
  centre_ = 0.5 * (box.low + box.high);
  size_ = box.diagonal() > 0 ? box.diagonal() / 2 : 1;

  const auto frame = [&](const std::vector<Vec3>& points) {
    for (const Vec3& p : points) {
      const bool inside = p.x >= box.low.x && p.y >= box.low.y && p.z >= box.low.z && p.x <= box.high.x &&
                          p.y <= box.high.y && p.z <= box.high.z;
      if (inside) framed_.push_back(to_stage(p));
    }
  };
  for (const DressedCloth& cloth : cloths) {
    if (fits(cloth)) frame(*cloth.positions);
  }
  if (body != nullptr && !is_plane(body)) frame(body->surface().points);
}

/// The smooth surface swings out at sharp folds: the points it added, from `first` on, must not dip into the body
/// there.
void Stage::keep_outside(const Body& body, std::size_t first, std::vector<Vec3>& points) const {
  for (std::size_t i = first; i < points.size(); ++i) {
    const auto surface = body.nearest(from_stage(points[i]), 0);
    if (surface && surface->distance > -kDeepestDip) points[i] = to_stage(surface->point);
  }
}

void Stage::add_cloth(const DressedCloth& cloth, const std::optional<FieldScale>& scale, const Body* body) {
  Surface surface;
  for (const Vec3& p : *cloth.positions) surface.points.push_back(is_finite(p) ? to_stage(p) : Vec3{});
  const std::vector<double> values = scale ? at_vertices(*cloth.shown, *cloth.cloth) : std::vector<double>{};
  const auto value = [&](int vertex) {
    const double v = index(vertex) < values.size() ? values[index(vertex)] : 0;
    return std::isfinite(v) ? v : 0;
  };
  for (const ClothTriangle& triangle : cloth.cloth->triangles) {
    if (cloth.only && triangle.layer != *cloth.only) continue;
    const auto& corner = triangle.vertices;
    if (!std::all_of(corner.begin(), corner.end(), [&](int i) { return is_finite((*cloth.positions)[index(i)]); }))
      continue;
    surface.triangles.push_back(corner);
    surface.uv.push_back(triangle.uv);
    surface.seam.push_back(seam_distances(*cloth.cloth, triangle));
    if (scale) surface.value.push_back({value(corner[0]), value(corner[1]), value(corner[2])});
  }
  surface.normals = corner_normals(surface.points, surface.triangles, EdgeTable(surface.triangles), kClothCrease);

  Actor actor;
  actor.material = Material::Cloth;
  // Between garments that lie on each other there is no room for a smoother surface than was computed.
  actor.surface = cloth.only ? std::move(surface) : smoothed(std::move(surface));
  if (body != nullptr) keep_outside(*body, cloth.positions->size(), actor.surface.points);
  actor.textile.emplace(cloth.textile);
  actor.scale = scale;
  actor.mean = scale ? grey(0.6) : actor.textile->mean();
  actors_.push_back(std::move(actor));
}

void Stage::add_body(const Body& body) {
  Actor actor;
  Surface& surface = actor.surface;
  for (const Vec3& p : body.surface().points) surface.points.push_back(is_finite(p) ? to_stage(p) : Vec3{});
  surface.triangles = body.surface().triangles;
  surface.normals = corner_normals(surface.points, surface.triangles, EdgeTable(surface.triangles), kBodyCrease);

  std::vector<Vec3> outward(surface.points.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) outward[index(surface.triangles[t][c])] += surface.normals[t][c];
  }
  const double inset = std::min(kInset / size_, 0.01);
  for (std::size_t i = 0; i < outward.size(); ++i) {
    if (norm(outward[i]) > 0) surface.points[i] += -inset * normalized(outward[i]);
  }
  actor.mean = kIvory;
  actors_.push_back(std::move(actor));
}

void Stage::set_floor(const Body* body) {
  double lowest = 0;
  for (const Vec3& p : framed_) lowest = std::min(lowest, p.z);
  constexpr double kFarthest = 0.14;  // below the subject, in its own size
  const double ground = is_plane(body) ? std::get<PlaneSpec>(body->spec().shape).height : 0;
  const double height = (ground - centre_.z) / size_;
  floor_ = is_plane(body) ? height : std::clamp(height, lowest - kFarthest, lowest);
  floor_ -= std::min(kInset / size_, 0.01);
}

}  // namespace toile
