#include "runtime/body/round_shape.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double at_the_core = 1e-12;  // [m] closer to the core than this the offset gives no direction

double sign(double x) {
  return x < 0 ? -1 : 1;
}

SignedDistance to_core(const BoxCore& box, Vec3 p) {
  const Vec3 excess{std::abs(p.x) - box.half.x, std::abs(p.y) - box.half.y, std::abs(p.z) - box.half.z};
  const Vec3 outside{sign(p.x) * std::max(excess.x, 0.0), sign(p.y) * std::max(excess.y, 0.0),
                     sign(p.z) * std::max(excess.z, 0.0)};
  if (const double d = norm(outside); d > at_the_core) return {d, outside / d};
  if (excess.z >= excess.x && excess.z >= excess.y) return {excess.z, {0, 0, sign(p.z)}};
  if (excess.y >= excess.x) return {excess.y, {0, sign(p.y), 0}};
  return {excess.x, {sign(p.x), 0, 0}};
}

SignedDistance to_core(const CylinderCore& cylinder, Vec3 p) {
  const Vec3 along = cylinder.upright ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const double height = dot(p, along);
  const Vec3 across = p - height * along;
  const double radius = norm(across);
  const Vec3 outwards = radius > at_the_core ? across / radius : Vec3{0, -1, 0};
  const double beside = radius - cylinder.radius;
  const double beyond = std::abs(height) - cylinder.half_length;
  const Vec3 endwards = sign(height) * along;
  if (beside > 0 || beyond > 0) {
    const Vec3 offset = std::max(beside, 0.0) * outwards + std::max(beyond, 0.0) * endwards;
    if (const double d = norm(offset); d > at_the_core) return {d, offset / d};
  }
  if (beyond >= beside) return {beyond, endwards};
  return {beside, outwards};
}

}  // namespace

SignedDistance signed_distance(const RoundShape& shape, Vec3 p) {
  SignedDistance result = std::visit([&](const auto& core) { return to_core(core, p - shape.centre); }, shape.core);
  result.distance -= shape.rounding;
  return result;
}

}  // namespace toile
