#include "runtime/energy/bending.hpp"

#include <cmath>

namespace toile {

BendingShape bending_shape(const std::array<Vec2, 3>& uv) {
  BendingShape shape;
  shape.area = 0.5 * std::abs(cross(uv[1] - uv[0], uv[2] - uv[0]));
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Vec2 edge = uv[(corner + 2) % 3] - uv[(corner + 1) % 3];
    const double length = norm(edge);
    const Vec2 outward = Vec2{edge.y, -edge.x} / length;
    shape.warp[corner] = length * outward.x * outward.x / shape.area;
    shape.weft[corner] = length * outward.y * outward.y / shape.area;
    shape.twist[corner] = length * outward.x * outward.y / shape.area;
  }
  return shape;
}

Curvatures curvatures(const BendingShape& shape, const Angles& angles) {
  Curvatures k;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    k.warp += shape.warp[corner] * angles[corner];
    k.weft += shape.weft[corner] * angles[corner];
    k.twist += shape.twist[corner] * angles[corner];
  }
  return k;
}

BendingEnergy bending_energy(const FabricLaw& law, const BendingShape& shape, const Angles& angles, Angles* moments,
                             const ClothMemory* memory) {
  const Curvatures k = curvatures(shape, angles);
  const Density warp = density(law.bend_warp, k.warp, memory != nullptr ? &memory->bend_warp : nullptr);
  const Density weft = density(law.bend_weft, k.weft, memory != nullptr ? &memory->bend_weft : nullptr);
  if (moments != nullptr) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      (*moments)[corner] = shape.area * (warp.force * shape.warp[corner] + weft.force * shape.weft[corner] +
                                         4 * law.twist * k.twist * shape.twist[corner]);
    }
  }
  return {shape.area * warp.energy, shape.area * weft.energy, shape.area * 2 * law.twist * k.twist * k.twist};
}

Matrix3 bending_hessian(const FabricLaw& law, const BendingShape& shape, const Angles& angles,
                        const ClothMemory* memory) {
  const Curvatures k = curvatures(shape, angles);
  const Density along_warp = density(law.bend_warp, k.warp, memory != nullptr ? &memory->bend_warp : nullptr);
  const Density along_weft = density(law.bend_weft, k.weft, memory != nullptr ? &memory->bend_weft : nullptr);
  const Eigen::Map<const Vector3> warp(shape.warp.data()), weft(shape.weft.data()), twist(shape.twist.data());
  return shape.area * (along_warp.stiffness * warp * warp.transpose() + along_weft.stiffness * weft * weft.transpose() +
                       4 * law.twist * twist * twist.transpose());
}

namespace {

/// What bending_shape() changes by as the corner `moved` moves along `way`; the area comes out as its share.
BendingShape shape_change(const std::array<Vec2, 3>& uv, const BendingShape& shape, std::size_t moved, Vec2 way) {
  BendingShape change;
  change.area = 0.5 * cross(uv[(moved + 2) % 3] - uv[(moved + 1) % 3], way) / shape.area;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Vec2 edge = uv[(corner + 2) % 3] - uv[(corner + 1) % 3];
    const Vec2 edge_change = corner == moved ? Vec2{} : (corner + 2) % 3 == moved ? way : -1.0 * way;
    const double length = norm(edge);
    const double fading = dot(edge, edge_change) / (length * length) + change.area;
    const double scale = 1 / (length * shape.area);
    // The edge turned outwards is (edge.y, -edge.x).
    change.warp[corner] = 2 * edge.y * edge_change.y * scale - shape.warp[corner] * fading;
    change.weft[corner] = 2 * edge.x * edge_change.x * scale - shape.weft[corner] * fading;
    change.twist[corner] = -(edge.x * edge_change.y + edge.y * edge_change.x) * scale - shape.twist[corner] * fading;
  }
  return change;
}

}  // namespace

Matrix36 bending_by_pattern(const FabricLaw& law, const std::array<Vec2, 3>& uv, const Angles& angles) {
  const BendingShape shape = bending_shape(uv);
  const Curvatures k = curvatures(shape, angles);
  const Density warp = law.bend_warp(k.warp), weft = law.bend_weft(k.weft);
  Angles moments{};
  bending_energy(law, shape, angles, &moments);
  Matrix36 mixed;
  for (std::size_t moved = 0; moved < 3; ++moved) {
    for (const int axis : {0, 1}) {
      const BendingShape change = shape_change(uv, shape, moved, axis == 0 ? Vec2{1, 0} : Vec2{0, 1});
      const Curvatures dk = curvatures(change, angles);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const double by_shape = warp.force * change.warp[corner] + weft.force * change.weft[corner] +
                                4 * law.twist * k.twist * change.twist[corner];
        const double by_curvature = warp.stiffness * dk.warp * shape.warp[corner] +
                                    weft.stiffness * dk.weft * shape.weft[corner] +
                                    4 * law.twist * dk.twist * shape.twist[corner];
        mixed(static_cast<Eigen::Index>(corner), static_cast<Eigen::Index>(2 * moved) + axis) =
            change.area * moments[corner] + shape.area * (by_shape + by_curvature);
      }
    }
  }
  return mixed;
}

}  // namespace toile
