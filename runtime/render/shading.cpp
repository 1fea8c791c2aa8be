#include "runtime/render/shading.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "runtime/render/cloth_brdf.hpp"
#include "runtime/render/yarns.hpp"

namespace toile {
namespace {

using std::numbers::pi;
/// Rays start this far off a surface of unit size: well above the rounding of single precision.
constexpr double kOffset = 2e-5;
constexpr double kWrongSide = 0.80;  // the inside of a cloth is a little duller
constexpr double kClothSheen = 0.20;
constexpr double kFormSheen = 0.06;     // the form is covered in linen
constexpr double kFieldContrast = 0.5;  // of the light on false colours, so that they can be read off the scale

/// A seam draws the cloth in: a shallow groove, darkest in the middle.
double groove(double distance) {
  constexpr double kHalfWidth = 1.4e-3;  // [m]
  constexpr double kDepth = 0.42;
  const double t = std::clamp(1 - distance / kHalfWidth, 0.0, 1.0);
  return 1 - kDepth * t * t * (3 - 2 * t);
}

}  // namespace

Rgb Shading::colour(const Spot& spot) const {
  const Actor& actor = *spot.actor;
  if (actor.scale) return actor.scale->colour(spot.value);
  if (!actor.textile) return actor.mean;
  const double shade = (spot.right_side ? 1.0 : kWrongSide) * yarn_shade(spot.uv, spot.footprint) * groove(spot.seam);
  return shade * actor.textile->at(spot.uv, spot.footprint);
}

Shaded Shading::actor(const Spot& spot, Vec3 to_viewer, Sample2 key, Sample2 dome) const {
  const bool false_colour = spot.actor->scale.has_value();
  // Black still has a sheen: it is told as light on a colour that is not quite black.
  const Rgb own = colour(spot);
  const Rgb base{std::clamp(own.r, 0.01, 1.0), std::clamp(own.g, 0.01, 1.0), std::clamp(own.b, 0.01, 1.0)};
  const double sheen = spot.actor->material == Material::Form ? kFormSheen : kClothSheen;
  const ClothBrdf brdf = false_colour ? ClothBrdf(grey(0.9), {}) : ClothBrdf(base, sheen * mix(grey(1), base, 0.5));

  Rgb seen;
  const Vec3 origin = spot.position + kOffset * spot.flat;
  const Vec3 to_key = cone_direction(Frame(studio_.key_direction()), studio_.key_cos_half_angle(), key);
  const double cos_key = dot(spot.normal, to_key);
  if (cos_key > 0 && luminance(studio_.key_irradiance()) > 0 && !stage_.rays().is_blocked({origin, to_key})) {
    seen += cos_key * (brdf(spot.normal, to_key, to_viewer) * studio_.key_irradiance());
  }
  // Drawn with the cosine: what remains of the estimate is pi times the scattering.
  const Vec3 to_dome = cosine_direction(Frame(spot.normal), dome);
  const Rgb scattered = brdf(spot.normal, to_dome, to_viewer);
  if (luminance(scattered) > 0) seen += pi * (scattered * incoming({origin, to_dome}));

  if (false_colour) return {base, mix(grey(1), grey(luminance(seen)), kFieldContrast)};
  return {base, seen / base};
}

Rgb Shading::incoming(const Ray& ray) const {
  const auto hit = stage_.rays().nearest(ray);
  if (!hit) return studio_.dome(ray.direction);
  return studio_.nook() * stage_.actors()[static_cast<std::size_t>(hit->mesh)].mean;
}

Rgb Shading::floor(Vec3 position, Sample2 key, Sample2 dome) const {
  const Vec3 origin = position + Vec3{0, 0, kOffset};
  const Frame up({0, 0, 1});
  const Vec3 to_key = cone_direction(Frame(studio_.key_direction()), studio_.key_cos_half_angle(), key);
  const Rgb key_light = std::max(0.0, studio_.key_direction().z) * studio_.key_irradiance();
  // With the actors and without them under the same draw, so that an open floor is exactly 1 and no sample is negative.
  const Vec3 to_dome = cosine_direction(up, dome);
  const Rgb open = key_light + pi * studio_.dome(to_dome);
  Rgb reached = pi * incoming({origin, to_dome});
  if (!stage_.rays().is_blocked({origin, to_key})) reached += key_light;
  return reached / open;
}

}  // namespace toile
