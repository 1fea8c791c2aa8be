// Where darts would take most of the strain out of pieces that are drawn on a body, found by trying.
#pragma once

#include <string>
#include <vector>

#include "compiler/pattern/draft.hpp"
#include "runtime/body/body.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

/// What is left in a piece as it lies on the form.
struct ResidualStrain {
  double energy = 0;  // [J]
  double p95 = 0;     // 95 % of the cloth have no elongation, compression or shear [rad] beyond this
};

struct ProposedDart {
  std::string piece;
  DraftDart dart;          // a slit in the chart
  ResidualStrain without;  // what would be left if it were left out of all
  ResidualStrain with;     // what is left in the piece
};

struct DartProposal {
  DraftGarment draft;  // with the proposed darts
  std::vector<ProposedDart> darts;
  int developments = 0;  // that were made to find them
};

/// Darts for each piece of a garment that is drawn on a body, as few as bring its residual strain to `strain`; where no
/// further dart does much good there may be fewer, and more left. `triangles`: of a piece, for the strain that counts.
DartProposal propose_darts(const DraftGarment& draft, const Body& body, double strain, int triangles, const Job& job);

/// What would be left in their pieces without each of the darts that a garment is drawn with: what a cut there gains.
std::vector<ProposedDart> without_each_dart(const DraftGarment& draft, const Body& body, int triangles, const Job& job);

/// A dart that is not made, and what it would do: cut there, the cloth would open, or lap over where the form is a
/// saddle and wants more of it.
struct TriedDart {
  std::string piece;
  DraftDart dart;
  ResidualStrain without, with;  // what is left in the piece
  double opening = 0;            // [m] of its mouth in the plane
  bool opens = false;            // or else laps over
};

/// The darts that the pieces of a garment only try. None of a piece that cannot be developed with it.
std::vector<TriedDart> try_darts(const DraftGarment& draft, const Body& body, int triangles, const Job& job);

/// Of a flat pattern whose strains and areas of triangles are these.
double worst_strain_p95(const std::vector<double>& warp, const std::vector<double>& weft,
                        const std::vector<double>& shear, const std::vector<double>& areas);

}  // namespace toile
