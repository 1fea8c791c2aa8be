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

}  // namespace toile
