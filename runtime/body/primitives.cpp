#include "runtime/body/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "runtime/body/primitive_mesh.hpp"
#include "runtime/body/round_shape.hpp"

namespace toile {
namespace {

constexpr double edge_rounding = 0.002;  // [m]

bool is_size(double length) {
  return length >= 1e-4 && length <= 100;
}

// A circle about a vertical or a lying axis, from the front; `hang` is the axis of what is worn there.
BodyLine circle(std::string name, Vec3 centre, double radius, Vec3 hang) {
  constexpr int count = 256;
  BodyLine line{std::move(name), {}, 2 * count * radius * std::sin(std::numbers::pi / count), hang};
  const Vec3 side = cross(hang, Vec3{0, 1, 0});  // where a quarter turn from the front leads, seen from the root
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    line.points.push_back(centre + radius * (std::sin(angle) * side - std::cos(angle) * Vec3{0, 1, 0}));
  }
  return line;
}

class RoundBody final : public Body {
 public:
  RoundBody(BodySpec spec, RoundShape shape, std::vector<BodyLine> lines)
      : spec_(std::move(spec)),
        shape_(shape),
        surface_(triangulate(shape)),
        lines_(std::move(lines)),
        top_(shape.centre) {
    for (const Vec3& p : surface_.points) top_.z = std::max(top_.z, p.z);
  }
  const BodySpec& spec() const override { return spec_; }
  const Surface& surface() const override { return surface_; }
  const std::vector<BodyLine>& lines() const override { return lines_; }
  Vec3 top() const override { return top_; }
  std::optional<SurfacePoint> nearest(Vec3 p, double reach) const override {
    const SignedDistance d = signed_distance(shape_, p);
    if (!(d.distance <= reach)) return std::nullopt;
    return SurfacePoint{p - d.distance * d.gradient, d.gradient, d.distance, -1};
  }

 private:
  BodySpec spec_;
  RoundShape shape_;
  Surface surface_;
  std::vector<BodyLine> lines_;
  Vec3 top_;
};

class PlaneBody final : public Body {
 public:
  PlaneBody(BodySpec spec, double height)
      : spec_(std::move(spec)), height_(height), surface_(triangulate_plane(height)) {}
  const BodySpec& spec() const override { return spec_; }
  const Surface& surface() const override { return surface_; }
  const std::vector<BodyLine>& lines() const override { return lines_; }
  Vec3 top() const override { return {0, 0, height_}; }
  std::optional<SurfacePoint> nearest(Vec3 p, double reach) const override {
    const double distance = p.z - height_;
    if (!(distance <= reach)) return std::nullopt;
    return SurfacePoint{{p.x, p.y, height_}, {0, 0, 1}, distance, -1};
  }

 private:
  BodySpec spec_;
  double height_;
  Surface surface_;
  std::vector<BodyLine> lines_;
};

struct Shaped {
  RoundShape shape;
  std::vector<BodyLine> lines;
};

std::optional<Shaped> shaped(const SphereSpec& s) {
  if (!is_size(s.radius)) return std::nullopt;
  const Vec3 centre{0, 0, s.height};
  return Shaped{{centre, BoxCore{}, s.radius}, {circle("equator", centre, s.radius, {0, 0, -1})}};
}

std::optional<Shaped> shaped(const CylinderSpec& c) {
  if (!is_size(c.radius) || !is_size(c.length)) return std::nullopt;
  const double rounding = std::min({edge_rounding, c.radius / 4, c.length / 4});
  const double half = c.length / 2 - rounding;
  const Vec3 centre{0, 0, c.height};
  const Vec3 hang = c.upright ? Vec3{0, 0, -1} : Vec3{1, 0, 0};
  Shaped result{{centre, CylinderCore{c.radius - rounding, half, c.upright}, rounding}, {}};
  const char* start = c.upright ? "top" : "right";
  const char* end = c.upright ? "bottom" : "left";
  result.lines.push_back(circle(start, centre - half * hang, c.radius, hang));
  result.lines.push_back(circle("middle", centre, c.radius, hang));
  result.lines.push_back(circle(end, centre + half * hang, c.radius, hang));
  return result;
}

std::optional<Shaped> shaped(const DiscSpec& d) {
  if (!is_size(d.radius) || !is_size(d.thickness) || d.thickness >= d.radius) return std::nullopt;
  const double rounding = d.thickness / 2;
  const Vec3 centre{0, 0, d.height - rounding};
  return Shaped{{centre, CylinderCore{d.radius - rounding, 0, true}, rounding},
                {circle("rim", centre, d.radius, {0, 0, -1})}};
}

std::optional<Shaped> shaped(const BoxSpec& b) {
  if (!is_size(b.width) || !is_size(b.depth) || !is_size(b.tall)) return std::nullopt;
  const double rounding = std::min({edge_rounding, b.width / 4, b.depth / 4, b.tall / 4});
  const Vec3 half{b.width / 2 - rounding, b.depth / 2 - rounding, b.tall / 2 - rounding};
  return Shaped{{{0, 0, b.height - b.tall / 2}, BoxCore{half}, rounding}, {}};
}

template <class Other>
std::optional<Shaped> shaped(const Other&) {
  return std::nullopt;
}

}  // namespace

std::shared_ptr<const Body> make_primitive(const BodySpec& spec, std::string* error) {
  if (const auto* plane = std::get_if<PlaneSpec>(&spec.shape)) return std::make_shared<PlaneBody>(spec, plane->height);
  std::optional<Shaped> result = std::visit([](const auto& shape) { return shaped(shape); }, spec.shape);
  if (!result || !std::isfinite(result->shape.centre.z)) {
    *error = "the sizes of a body must lie between 0.1 mm and 100 m, and a disc must be thinner than its radius";
    return nullptr;
  }
  return std::make_shared<RoundBody>(spec, result->shape, std::move(result->lines));
}

}  // namespace toile
