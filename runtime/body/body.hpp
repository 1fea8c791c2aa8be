// A body in space: a closed surface of triangles with named lines, and the questions that contact and placing ask of
// it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/pattern/body_spec.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile {

/// A closed line on the body. It starts at the wearer's front (for a limb: at the front of the limb) and runs
/// counter-clockwise seen against `axis` reversed, i.e. seen from where the garment hangs from: from above for neck and
/// waist.
struct BodyLine {
  std::string name;          // "neck", "bust", "waist", "hip", "left_armhole", "right_armhole", "left_crotch", …
  std::vector<Vec3> points;  // closed; the first is not repeated
  double girth = 0;          // [m] length of the closed polyline
  Vec3 axis{0, 0, -1};  // unit vector along which a garment worn here hangs or runs (down; along the arm; down the leg)
};

/// The nearest point of the surface.
struct SurfacePoint {
  Vec3 point;
  Vec3 normal;  // outward unit normal, continuous across edges (along the offset where the point is off the surface)
  double distance = 0;  // [m] signed, negative inside
  int triangle = -1;
};

/// How far a place is from the body, as contact sees it: smooth, also where the surface is made of facets.
struct Clearance {
  double distance = 0;            // [m] signed, negative inside
  Vec3 gradient;                  // by the place; a unit vector but for the smoothing
  std::array<Vec3, 3> hessian{};  // [1/m] by the place twice, its rows
};

class Body {
 public:
  struct Surface {
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>>
        triangles;  // outward, closed, 2-manifold (a plane: two triangles, half space below it inside)
  };

  /// Errors (a file that cannot be read, a plane that misses the mesh) come back as text in `error`; the body is then
  /// null.
  static std::shared_ptr<const Body> make(const BodySpec& spec, std::string* error);

  virtual ~Body() = default;
  virtual const BodySpec& spec() const = 0;
  virtual const Surface& surface() const = 0;
  virtual const std::vector<BodyLine>& lines() const = 0;
  const BodyLine* line(std::string_view name) const;

  /// The nearest point of the surface if it lies within `reach` [m] of p, or if p is inside at any depth. Thread-safe,
  /// deterministic.
  virtual std::optional<SurfacePoint> nearest(Vec3 p, double reach) const = 0;
  /// The same question with an answer that is continuous together with its gradient.
  virtual std::optional<Clearance> clearance(Vec3 p, double reach) const;
  /// Upper bound of z over the surface, and the centre of the top: where a cloth without worn lines is laid.
  virtual Vec3 top() const = 0;
};

}  // namespace toile
