// A developed pattern draped back on the form that it was developed for: where that starts, and how far from the form
// it comes to rest.
#pragma once

#include <vector>

#include "compiler/pattern/pattern.hpp"
#include "compiler/smesh/smesh.hpp"
#include "runtime/body/body.hpp"
#include "runtime/develop/target.hpp"
#include "runtime/drape/drape.hpp"

namespace toile {

/// On the form, half the cloth's thickness off the body; worn lines are held where they were drawn.
Placed start_on_form(const SMesh& mesh, const std::vector<Wear>& wears, const Target& target, const Body& body,
                     double half_thickness);

/// Weighted by the area of the cloth.
struct FormDistance {
  Spread distance;                // [m] from each vertex to the form's surface
  Spread slip;                    // [m] from each vertex to its own place on the form
  std::vector<double> of_vertex;  // [m] the distances
  std::vector<Vec3> across;       // unit vectors in which they grow
  std::vector<Vec3> slips;        // [m] from each vertex's own place on the form to it
};
FormDistance form_distance(const SMesh& mesh, const std::vector<Vec3>& form, const std::vector<Vec3>& draped,
                           const std::vector<double>& areas);

}  // namespace toile
