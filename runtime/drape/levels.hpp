// Draping coarse to fine: the first fall on few triangles, the equilibrium on all of them.
#pragma once

#include <string>
#include <vector>

#include "runtime/drape/drape.hpp"

namespace toile {

struct DrapeLevel {
  const SewnMesh* mesh = nullptr;
  const Cloth* cloth = nullptr;
};

struct DrapedLevels {
  Drape drape;        // of the finest level; `iterations` and `factorisations` count all levels
  std::string error;  // of placing: what could not be worn where; the drape is then empty
  double place_seconds = 0, solve_seconds = 0;
};

/// Places the coarsest mesh, drapes it, carries the form over to the next finer mesh, and so on. `meshes`: at least
/// one, coarse first.
DrapedLevels drape_levels(const std::vector<DrapeLevel>& meshes, const std::vector<Wear>& wears,
                          const std::vector<ArrangedPiece>& arranged, const std::vector<FabricSheet>& fabrics,
                          const Body* body, const DrapeOptions& options, const Job& job);

/// Drapes one mesh from a form near its rest, such as that of another pattern much like it.
DrapedLevels drape_from(const std::vector<Vec3>& start, const DrapeLevel& mesh, const std::vector<Wear>& wears,
                        const std::vector<ArrangedPiece>& arranged, const std::vector<FabricSheet>& fabrics,
                        const Body* body, const DrapeOptions& options, const Job& job);

/// Target edges [m] of the coarser levels below a mesh of so many triangles, the coarsest first; none for a small mesh.
std::vector<double> level_edges(double finest_edge, int triangles);

}  // namespace toile
