// How cloth scatters light: a matte base under a sheen of upright fibres.
#pragma once

#include "runtime/mesh/vec3.hpp"
#include "runtime/render/colour.hpp"

namespace toile {

/// The sheen is the microfibre distribution of Estevez & Kulla (2017) with Neubelt & Pettineo's visibility term (2013).
/// What it takes away is taken off the base on the way in and on the way out (in the manner of Kelemen 2001), so the
/// whole is reciprocal, and a white cloth under a white sky is exactly as white as the sky.
class ClothBrdf {
 public:
  /// `sheen`, 0 … 1 per channel, is the share of the fibre layer.
  ClothBrdf(Rgb base, Rgb sheen);

  /// Per steradian, for unit directions to the light and to the viewer with cosines against the normal in (0, 1] and
  /// the cosine of the angle between normal and halfway vector.
  Rgb operator()(double cos_light, double cos_view, double cos_half) const;
  /// The same from directions; zero where either lies below the surface.
  Rgb operator()(Vec3 normal, Vec3 to_light, Vec3 to_view) const;

 private:
  Rgb base_, sheen_, rest_;
};

/// The share of light from a direction that the full sheen layer sends back, by quadrature.
double sheen_albedo(double cosine);

}  // namespace toile
