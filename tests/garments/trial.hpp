// What becomes of a script when it is run: in a process of its own, so that a crash or a hang is found and not shared.
#pragma once

#include <string>

namespace toile::test {

enum class End {
  Rest,       // in equilibrium
  Reported,   // not in equilibrium, and a diagnostic says so
  Refused,    // an error in the script or in putting it on, and a diagnostic says which
  Crossing,   // the cloth passes through itself
  NotFinite,  // a coordinate or a figure that is no number
  Silent,     // not in equilibrium, and nothing said so
  Crash,
  Hang,  // more than the seconds of processor time that it was given
};

const char* name(End end);

struct Trial {
  End end = End::Crash;
  int triangles = 0, iterations = 0, crossing_pairs = 0;
  double residual = 0;     // relative
  double penetration = 0;  // [m]
  double pressure = 0;     // [Pa] the largest
  double seconds = 0;      // of the processor
  std::string said;        // diagnostics
};

/// Runs the script's first drape with about so many triangles on one thread.
Trial try_script(const std::string& script, int triangles, int most_seconds);

}  // namespace toile::test
