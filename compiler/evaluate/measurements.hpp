// Measurements of the body: their names here, in ISO 8559-1 and in other pattern programs, and what figures have.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// What this language calls a measurement: "waist" for `waist`, `waist_girth` and `waist_circ`; empty for any other
/// word, and for `hips`, which means different ones.
std::string_view measurement_called(std::string_view name);

/// Whether both words are names of one measurement.
bool same_measurement(std::string_view a, std::string_view b);

/// What to write for a word that programs use for different measurements; empty for all others.
std::string advice_on_measurement(std::string_view name);

struct Measured {
  std::string name;
  Value value;
  Location at;
  bool given = true;  // no default
};

/// Warns of what no figure has: a girth of 300 cm, a wrist larger than its upper arm; not of defaults alone. What no
/// doll has either is an error, and false. `whose` begins the sentence: "size `M`".
bool check_measurements(Session& session, const std::string& whose, const std::vector<Measured>& measures);

}  // namespace toile
