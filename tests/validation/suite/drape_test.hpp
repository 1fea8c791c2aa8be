// Cusick's drape test: a round cloth on a smaller round disc, its shadow and its folds.
#pragma once

#include <string>
#include <vector>

#include "compiler/pattern/fabric_sheet.hpp"
#include "compiler/smesh/smesh.hpp"
#include "runtime/body/body.hpp"
#include "runtime/drape/drape.hpp"

namespace toile::validation {

struct Tester {
  double specimen, disc;  // [m] radii
  std::string name;
};

struct DrapeFigures {
  double coefficient = 0;  // [%] of the ring that the shadow covers
  int folds = 0;
  double energy = 0;  // [J] without friction
  bool at_rest = false;
};

/// One cloth on one tester.
class DrapeTest {
 public:
  DrapeTest(const FabricSheet& fabric, const Tester& tester);

  /// From flat, as every cloth without worn lines starts, coarse meshes first.
  DrapeFigures from_flat(double edge);
  /// The latest form on another mesh.
  DrapeFigures carried_to(double edge);

 private:
  SewnMesh mesh(double edge) const;
  DrapeFigures figures(const Drape& drape) const;
  Drape drape_on(const SewnMesh& mesh, const std::vector<Vec3>& start, bool carried) const;

  FabricSheet fabric_;
  Tester tester_;
  Garment garment_;
  std::shared_ptr<const Body> body_;
  SewnMesh mesh_;
  std::vector<Vec3> form_;
};

}  // namespace toile::validation
