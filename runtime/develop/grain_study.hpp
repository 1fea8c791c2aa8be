// What the direction of the grain does to a developed pattern.
#pragma once

#include <array>

#include "compiler/smesh/smesh.hpp"
#include "runtime/develop/develop.hpp"

namespace toile {

struct GrainStudy {
  static constexpr std::array<double, 3> turns{0, 45, 90};  // [deg] of the grain from where the pieces say it runs
  /// [J] in the cloth on the form: the pattern developed for the second turn, cut with its grain at the first.
  std::array<std::array<double, 3>, 3> energy{};
  std::array<double, 3> apart{};  // [m] root of the mean square from the pattern for the first turn, laid on each other
};

/// Develops the same pieces with the grain turned.
GrainStudy study_grain(const SewnMesh& mesh, const FabricLaw& law, const Development& development, const Job& job);

}  // namespace toile
