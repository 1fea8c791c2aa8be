// What there is to do at each step of the order of sewing.
#pragma once

#include <string>
#include <vector>

#include "compiler/pattern/sewing_order.hpp"

namespace toile {

struct SewingInstruction {
  SewingStep step;
  std::string operation;           // "dart", "seam", …
  std::string of;                  // what is sewn
  std::vector<std::string> lines;  // what to do, one thing after the other
};

std::vector<SewingInstruction> sewing_instructions(const Garment& garment);

}  // namespace toile
