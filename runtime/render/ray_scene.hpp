// Rays against triangles: Embree behind a plain face.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/mesh/vec3.hpp"

namespace toile {

struct Ray {
  Vec3 origin;
  Vec3 direction;  // need not be a unit vector: distances are in its lengths
};

struct RayHit {
  int mesh = 0;
  int triangle = 0;
  double b1 = 0, b2 = 0;  // barycentrics of the second and third corner
  double distance = 0;
};

/// A set of meshes that rays can be shot at. Adding is for one thread; questions may come from many at once. Positions
/// are held in single precision: bring a scene to about unit size first.
class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Returns the mesh's number: 0, 1, 2, … in the order of adding. An empty mesh is allowed.
  int add(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles);
  /// Once, after the last add.
  void commit();

  std::optional<RayHit> nearest(const Ray& ray) const;
  bool is_blocked(const Ray& ray) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace toile
