// What a state of the cloth amounts to: forces, energies, strains, stresses, pressures.
#pragma once

#include <string>
#include <vector>

#include "runtime/contact/body_contact.hpp"
#include "runtime/contact/self_contact.hpp"
#include "runtime/drape/drape.hpp"
#include "runtime/energy/elastic.hpp"
#include "runtime/energy/gravity.hpp"

namespace toile {

/// The energy's terms and where they stand.
struct ClothState {
  const Cloth& cloth;
  const std::vector<FabricLaw>& laws;  // of each fabric
  const ElasticForm& elastic;
  const GravityForm* gravity;  // null: weightless
  const BodyContact* contact;  // null: no body
  const SelfContact* layers;   // null: it may pass through itself
  const std::vector<int>& reduced;
  const Vector& q;
};

struct LargestResidual {
  double force = 0;   // [N]
  int vertex = -1;    // where that is
  double moment = 0;  // [N m]
};
LargestResidual largest_residual(const Vector& gradient, const ClothUnknowns& unknowns);

/// Sets the derivative by held unknowns to zero.
void clear_held(Vector& gradient, const std::vector<int>& reduced);

/// Everything of a Drape but how the solver fared.
Drape describe(const ClothState& state);

/// Why a drape did not come to rest, in words.
std::string trouble(const Drape& drape);

}  // namespace toile
