// Where a garment is tightest on its body, and what its pattern lacks there.
#pragma once

#include "runtime/export/export.hpp"

namespace toile {

struct Tightness {
  double pressure_Pa = 0;  // the largest of a vertex; 0 where nothing touches, and then nothing else is said
  PieceId piece = -1;
  Vec3 at;
  bool along_warp = false;  // the thread that draws the harder there …
  double strain = 0;        // … how far it is stretched …
  double length_m = 0;      // … how long it is in the pattern, through the piece from rim to rim …
  double short_m = 0;       // … and by how much it is stretched from rim to rim: so much the piece is too short
};

Tightness tightest(const DrapedGarment& draped);

}  // namespace toile
