// Dress forms: a trunk lofted through sections, arm stumps and legs, as one closed surface.
#pragma once

#include <string>
#include <vector>

#include "runtime/body/body.hpp"

namespace toile {

struct LinedSurface {
  Body::Surface surface;
  std::vector<BodyLine> lines;
  std::string error;  // the surface is empty then
};

/// Lines: one a named section; with arms left_armhole and right_armhole; with legs left_leg and right_leg, and, where a
/// section is named waist, left_crotch and right_crotch: from the front of the waist over that half of it to the back
/// and between the legs forward again.
LinedSurface make_form(const FormSpec& form);

}  // namespace toile
