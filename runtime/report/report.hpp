// The report of a drape as JSON, key by key as docs/report.md has it. Its bytes depend on the script alone.
#pragma once

#include <string>
#include <vector>

#include "runtime/export/export.hpp"

namespace toile {

struct Development;
struct GrainStudy;
struct ProposedDart;
struct Redrawn;
struct TriedDart;

std::string report_json(const std::string& script, const DrapedGarment& draped);

struct DartStudy {
  const std::vector<ProposedDart>& proposed;
  const std::vector<TriedDart>& tried;
  std::vector<ProposedDart> drawn;  // what would be left without each
};

/// The same of a development: the cloth as it lies on its form, what came out of flattening it, and what it was held
/// against: other grains, other darts.
std::string report_json(const std::string& script, const DrapedGarment& on_form, const Development& development,
                        const Redrawn& redrawn, const DartStudy& study, const GrainStudy& grain);

struct Profile {
  double compile_s = 0, mesh_s = 0, place_s = 0, solve_s = 0, total_s = 0, cpu_s = 0;
  long peak_memory_bytes = 0;
  int factorisations = 0;
};
std::string profile_json(const Profile& profile);

}  // namespace toile
