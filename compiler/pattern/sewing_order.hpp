// In which order a garment is sewn together.
#pragma once

#include <string>
#include <vector>

#include "compiler/pattern/pattern.hpp"

namespace toile {

/// One operation of a sewing line. Copies of a seam on both sides of a garment, and the layers of one seam, are one
/// step.
struct SewingStep {
  enum class Kind { Dart, Pleat, Seam, Closure, Hem, Buttons } kind = Kind::Seam;
  std::vector<int> seams;      // into Garment::seams; none of a hem and of buttons
  std::vector<EdgeRef> edges;  // free edges that are turned up
};

/// Darts first, then pleats; then seams and closures: those with a stated step in that order, else a seam comes as soon
/// as the pieces that its lines run over are joined, closures last, and as the script has them; then hems, and buttons.
std::vector<SewingStep> sewing_order(const Garment& garment);

}  // namespace toile
