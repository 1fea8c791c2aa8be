#include "tests/validation/suite/figures.hpp"

#include <fmt/format.h>

#include <cmath>

namespace toile::validation {

bool Figure::holds() const {
  return std::abs(found - reference) <= tolerance;
}

Figure near(std::string subject, std::string quantity, double reference, double found, double relative) {
  return {std::move(subject),
          std::move(quantity),
          reference,
          found,
          relative * std::abs(reference),
          fmt::format("{:g} %", 100 * relative)};
}

Figure within(std::string subject, std::string quantity, double reference, double found, double tolerance) {
  return {std::move(subject), std::move(quantity), reference, found, tolerance, fmt::format("{:g}", tolerance)};
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all{{"Catenary", catenary},
                                     {"KesSheets", kes_sheets},
                                     {"HeavyElastica", heavy_elastica},
                                     {"Plates", plates},
                                     {"Patches", patches},
                                     {"Contact", contact},
                                     {"DrapeCoefficients", drape_coefficients},
                                     {"Strips", strips},
                                     {"HungSpecimens", hung_specimens},
                                     {"RandomGarments", random_garments}};
  return all;
}

}  // namespace toile::validation
