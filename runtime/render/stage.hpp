// What stands in front of the camera, brought to unit size about the origin.
#pragma once

#include <optional>
#include <vector>

#include "runtime/render/field_scale.hpp"
#include "runtime/render/ray_scene.hpp"
#include "runtime/render/render.hpp"
#include "runtime/render/stripes.hpp"
#include "runtime/render/surface.hpp"

namespace toile {

enum class Material { Form, Cloth };

struct Actor {
  Material material = Material::Form;
  Surface surface;
  std::optional<TextileColour> textile;
  std::optional<FieldScale> scale;  // false colours instead
  Rgb mean;                         // what it throws on its neighbours
};

/// Farther from a seam than any that shows [m].
constexpr double kNoSeam = 1;

/// A place on an actor as the light finds it.
struct Spot {
  const Actor* actor = nullptr;
  Vec3 position;
  Vec3 flat;    // the triangle's normal, on the viewer's side
  Vec3 normal;  // the smooth one, likewise
  bool right_side = true;
  double value = 0;       // of the field shown
  Vec2 uv, footprint;     // [m] and how much of the cloth a pixel covers
  double seam = kNoSeam;  // [m] distance to the nearest one
};

class Stage {
 public:
  /// The body is drawn in by kInset, so that cloth which lies on it, its chords cutting through curved parts, is not
  /// pierced in the picture. Cloth is divided finer than it was computed, along its smooth normals.
  Stage(const std::vector<DressedCloth>& cloths, const Body* body);

  static constexpr double kInset = 1.5e-3;  // [m], less on bodies under 15 cm

  bool empty() const { return framed_.empty(); }
  const std::vector<Actor>& actors() const { return actors_; }
  const RayScene& rays() const { return rays_; }
  /// What the camera must get into the picture.
  const std::vector<Vec3>& framed() const { return framed_; }
  /// The floor's height; z = 0 of the script unless all is far above it.
  double floor() const { return floor_; }
  /// The first cloth's scale, if one shows a field.
  const FieldScale* scale() const;

  /// `pixel`: the width of a pixel at unit distance along the ray.
  Spot spot(const Ray& ray, const RayHit& hit, double pixel) const;

 private:
  void add_cloth(const DressedCloth& cloth, const std::optional<FieldScale>& scale, const Body* body);
  void add_body(const Body& body);
  void bring_to_unit_size(const std::vector<DressedCloth>& cloths, const Body* body);
  void set_floor(const Body* body);
  Vec3 to_stage(Vec3 p) const { return (p - centre_) / size_; }
  Vec3 from_stage(Vec3 p) const { return centre_ + size_ * p; }
  void keep_outside(const Body& body, std::size_t first, std::vector<Vec3>& points) const;

  std::vector<Actor> actors_;
  RayScene rays_;
  std::vector<Vec3> framed_;
  Vec3 centre_;
  double size_ = 1;  // [m]
  double floor_ = 0;
};

}  // namespace toile
