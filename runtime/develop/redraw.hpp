// The developed pattern redrawn as a pattern maker would have it: smooth edges with names, instead of a mesh.
#pragma once

#include <string>
#include <vector>

#include "compiler/pattern/draft.hpp"
#include "runtime/develop/develop.hpp"
#include "runtime/develop/fit.hpp"

namespace toile {

struct RedrawnEdge {
  std::string name;
  FittedCurve fitted;
};
struct RedrawnHole {
  std::string name;
  std::vector<RedrawnEdge> edges;
};
struct RedrawnPiece {
  std::vector<RedrawnEdge> outline;
  std::vector<RedrawnHole> holes;
};

struct Redrawn {
  DraftGarment draft;                // what make_garment() takes
  std::vector<RedrawnPiece> pieces;  // the same outlines by the points and directions that a script writes
  double error = 0;                  // [m] the farthest that a solved point of an outline lies from its curve
};

/// Edges keep their names; the parts of one that darts divide are numbered, copies are called `mirrored`, and the legs
/// of darts are edges that are sewn to each other.
Redrawn redraw(const Garment& garment, const SewnMesh& mesh, const Development& development, double tolerance);

}  // namespace toile
