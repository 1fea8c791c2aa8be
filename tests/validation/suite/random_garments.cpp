// Garments that nobody has thought of: how they end.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "tests/garments/random_garment.hpp"
#include "tests/garments/trial.hpp"
#include "tests/validation/suite/figures.hpp"

namespace toile::validation {
namespace {

using test::End;
using test::Trial;

constexpr int most_seconds = 120;

/// How many of a kind ended how.
struct Count {
  int tried = 0;
  std::map<End, int> ends;
  int of(End end) const {
    const auto found = ends.find(end);
    return found == ends.end() ? 0 : found->second;
  }
};

}  // namespace

Chapter random_garments(Effort effort) {
  const unsigned seeds = effort == Effort::Full ? 1000 : 4;
  const int triangles = effort == Effort::Full ? 300 : 150;
  Chapter chapter{
      "Random garments",
      fmt::format("Seeds 1 to {} of the generator in `tests/garments`: random outlines, seams, darts, pleats, "
                  "sizes; cloths from silk to leather, a quarter of them from 1 g/m² to 2 kg/m² with EMT 0.1 % "
                  "to 60 %; bodies or none; edges from 5 mm to 50 m. Each at about {} triangles (800 where arms "
                  "or legs are worn) on one thread, "
                  "to 10⁻³, in a process of its own with {} s of processor time. Each ends in rest, or the "
                  "report says what does not rest.",
                  seeds, triangles, most_seconds),
      {},
      {},
      {}};
  std::map<std::string, Count> kinds;
  Count all;
  std::string lists;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const test::RandomGarment garment = test::random_garment(seed);
    const Trial trial = test::try_script(garment.text, std::max(triangles, garment.least_triangles), most_seconds);
    Count& kind = kinds[garment.kind];
    for (Count* count : {&kind, &all}) {
      ++count->tried;
      ++count->ends[trial.end];
    }
    if (trial.end != End::Rest && trial.end != End::Reported) {
      lists += fmt::format("{}{} ({}, {})", lists.empty() ? "" : ", ", seed, garment.kind, name(trial.end));
    }
  }
  for (const End end : {End::Crash, End::Hang, End::NotFinite, End::Silent, End::Refused, End::Crossing}) {
    chapter.figures.push_back(
        within(fmt::format("{} garments", all.tried), fmt::format("that end so: {}", name(end)), 0, all.of(end), 0));
  }
  for (const auto& [name, count] : kinds) {
    chapter.remarks.push_back(
        fmt::format("{}: {} of {} come to rest, {} are reported as not at rest, {} pass through "
                    "themselves",
                    name, count.of(End::Rest), count.tried, count.of(End::Reported), count.of(End::Crossing)));
  }
  if (!lists.empty()) chapter.remarks.push_back("Seeds that end neither in rest nor in a report: " + lists);
  return chapter;
}

}  // namespace toile::validation
