// Drape coefficients of published fabrics.
#include <fmt/format.h>

#include <cmath>

#include "tests/validation/suite/drape_test.hpp"
#include "tests/validation/suite/figures.hpp"
#include "tests/validation/suite/library.hpp"

namespace toile::validation {
namespace {

const Tester cusick{0.15, 0.09, "30 cm on 18 cm"};
const Tester japanese{0.127, 0.0635, "25.4 cm on 12.7 cm"};

struct Measured {
  const char* fabric;
  const Tester* tester;
  double coefficient;  // [%]
  int nodes;           // 0: not published
};

struct Sums {
  double differences = 0;
  int count = 0;
};

std::string form(const DrapeFigures& found) {
  return fmt::format("{} folds, {:.1f} %, {:.6f} J{}", found.folds, found.coefficient, found.energy,
                     found.at_rest ? "" : ", not at rest");
}

void add_lines(const Measured& each, Effort effort, Sums& sums, Chapter& chapter) {
  DrapeTest test(fabric_called(each.fabric), *each.tester);
  const std::string subject = fmt::format("{}, {}", each.fabric, each.tester->name);
  const DrapeFigures flat = test.from_flat(effort == Effort::Full ? 0.005 : 0.01);
  chapter.figures.push_back(within(subject, "drape coefficient [%]", each.coefficient, flat.coefficient, 9));
  if (each.nodes > 0) chapter.figures.push_back(within(subject, "folds", each.nodes, flat.folds, 2));
  sums.differences += std::abs(flat.coefficient - each.coefficient);
  ++sums.count;
  if (effort == Effort::Quick) return;
  const DrapeFigures finer = test.carried_to(0.0035);
  chapter.figures.push_back(within(subject,
                                   fmt::format("drift from 5 to 3.5 mm, {} to {} folds", flat.folds, finer.folds), 0,
                                   finer.coefficient - flat.coefficient, 1));
  chapter.remarks.push_back(fmt::format("{}: {}; at 3.5 mm {}.", subject, form(flat), form(finer)));
}

}  // namespace

Chapter drape_coefficients(Effort effort) {
  Chapter chapter{
      "Cusick's drape test on published fabrics",
      "Petrak et al. (2025) and Matsudaira et al. (2015, on the tester of JIS L 1096), drape coefficients in per cent; "
      "rows that were not published take class values. Draped from flat, as every cloth is; states of less energy are "
      "not sought. A single fabric is held to 9 points, the mean of all to 9.",
      {},
      {},
      {}};
  const std::vector<Measured> measured{{"polyester_twill", &cusick, 22.3, 0},
                                       {"polyester_plain", &cusick, 22.8, 0},
                                       {"wool_blend_twill", &cusick, 34.9, 0},
                                       {"polyester_tropical", &japanese, 50.7, 5},
                                       {"polyester_faille", &japanese, 28.3, 7}};
  Sums sums;
  for (const Measured& each : measured) {
    if (effort == Effort::Full || each.nodes > 0) add_lines(each, effort, sums, chapter);
  }
  if (effort == Effort::Full) {
    chapter.figures.push_back(within("all", "mean difference [points]", 0, sums.differences / sums.count, 9));
  }
  return chapter;
}

}  // namespace toile::validation
