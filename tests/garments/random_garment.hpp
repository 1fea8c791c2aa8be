// Garments that nobody has thought of: a seed gives a whole script, valid as the language has it.
#pragma once

#include <string>
#include <vector>

namespace toile::test {

struct RandomGarment {
  std::string kind;         // "cloth on a body", "skirt of gores", …
  std::string text;         // the script; its last line drapes the garment
  int least_triangles = 0;  // with fewer a limb is no tube
};

/// One of each kind in turn: of a run of seeds every kind gets its share. Cloths reach from silk to leather and beyond
/// (1 g/m2 to 2 kg/m2, EMT 0.1 % to 60 %), edges from 5 mm to 50 m where no figure wears them.
RandomGarment random_garment(unsigned seed);

const std::vector<std::string>& kinds_of_random_garments();

}  // namespace toile::test
