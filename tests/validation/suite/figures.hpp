// The validation suite as figures: what was found, what it should be, how near it is held. The tests and
// docs/validation.md are made of the same.
#pragma once

#include <string>
#include <vector>

#include "runtime/export/plot.hpp"

namespace toile::validation {

/// How far to go: sizes for every day, or all of it.
enum class Effort { Quick, Full };

struct Figure {
  std::string subject;   // "Γ = 5, irregular mesh"
  std::string quantity;  // "x / L"
  double reference = 0;
  double found = 0;
  double tolerance = 0;  // of the difference, in the quantity's own measure
  std::string held_to;   // the same in words: "0.2 %"
  bool holds() const;
};

/// Held to a part of the reference.
Figure near(std::string subject, std::string quantity, double reference, double found, double relative);
/// Held to so much.
Figure within(std::string subject, std::string quantity, double reference, double found, double tolerance);

struct Picture {
  std::string name;  // of the file, without its ending
  std::string caption;
  std::vector<PlotPanel> panels;
};

struct Chapter {
  std::string title;
  std::string reference;  // what the figures are compared with, and where it is from
  std::vector<Figure> figures;
  std::vector<Picture> pictures;
  std::vector<std::string> remarks;
};

struct Case {
  const char* name;  // as tests call it
  Chapter (*run)(Effort);
};

const std::vector<Case>& cases();

Chapter heavy_elastica(Effort);
Chapter strips(Effort);
Chapter plates(Effort);
Chapter patches(Effort);
Chapter catenary(Effort);
Chapter contact(Effort);
Chapter kes_sheets(Effort);
Chapter hung_specimens(Effort);
Chapter drape_coefficients(Effort);
Chapter random_garments(Effort);

}  // namespace toile::validation
