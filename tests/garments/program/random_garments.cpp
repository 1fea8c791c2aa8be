// `random_garments FIRST LAST TRIANGLES [--print]`: tries the garments of these seeds, a line for each, and counts how
// they end. With --print the scripts stand on the standard output instead and nothing is tried.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "tests/garments/random_garment.hpp"
#include "tests/garments/trial.hpp"

int main(int argc, char** argv) {
  using namespace toile::test;  // NOLINT
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 3) {
    fmt::print(stderr, "random_garments FIRST LAST TRIANGLES [--print]\n");
    return 2;
  }
  const auto first = static_cast<unsigned>(std::atoi(arguments[0].c_str()));
  const auto last = static_cast<unsigned>(std::atoi(arguments[1].c_str()));
  const int triangles = std::atoi(arguments[2].c_str());
  constexpr int most_seconds = 120;
  std::map<std::string, int> count;
  for (unsigned seed = first; seed <= last; ++seed) {
    const RandomGarment garment = random_garment(seed);
    if (arguments.size() > 3) {
      fmt::print("{}", garment.text);
      continue;
    }
    const Trial trial = try_script(garment.text, std::max(triangles, garment.least_triangles), most_seconds);
    ++count[name(trial.end)];
    fmt::print("{:5} {:20} {:10} {:6} tri {:5} it {:8.2g} res {:4} cross {:7.2g} mm {:6.2f} s {}\n", seed, garment.kind,
               name(trial.end), trial.triangles, trial.iterations, trial.residual, trial.crossing_pairs,
               1000 * trial.penetration, trial.seconds, trial.said.substr(0, 300));
    std::fflush(stdout);
  }
  for (const auto& [how, times] : count) fmt::print("{}: {}\n", how, times);
}
