// The families of meshes that every case is tried on.
#pragma once

#include <array>

#include "runtime/fabric/law.hpp"
#include "runtime/laboratory/specimen.hpp"

namespace toile::validation {

enum class Mesh { OneWay, Irregular, Pieces };
inline constexpr std::array<Mesh, 3> all_meshes{Mesh::OneWay, Mesh::Irregular, Mesh::Pieces};
const char* name(Mesh mesh);

/// [0, width] x [0, height] in triangles of about that edge; the warp at that angle [rad] from x.
Specimen sheet(Mesh mesh, double width, double height, double edge, double warp = 0);

/// Cloth that hardly stretches, whose bending alone matters: rigidities [N m], weight [kg/m2], membrane [N/m].
FabricLaw bending_cloth(WarpWeft rigidity, double twist, double weight, double membrane);

inline bool near_to(double a, double b) {
  return std::abs(a - b) < 1e-9;
}

constexpr double degree = 0.017453292519943295;

}  // namespace toile::validation
