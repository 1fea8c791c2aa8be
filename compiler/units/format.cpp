#include "compiler/units/format.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace toile {
namespace {

/// A unit for values from `from` [SI] upwards.
struct Choice {
  double from;
  double factor;
  std::string_view symbol;
};

struct Preference {
  Dimension dimension;
  std::vector<Choice> choices;  // `from` falling, the last from 0
};

const std::vector<Preference>& preferences() {
  using namespace dimension;
  static const std::vector<Preference> all{
      {length, {{10, 1, "m"}, {1e-2, 1e-2, "cm"}, {1e-4, 1e-3, "mm"}, {0, 1e-6, "um"}}},
      {area, {{0.5, 1, "m^2"}, {0, 1e-4, "cm^2"}}},
      {angle, {{0, std::numbers::pi / 180, "deg"}}},
      {mass, {{1, 1, "kg"}, {1e-3, 1e-3, "g"}, {0, 1e-6, "mg"}}},
      {time, {{0, 1, "s"}}},
      {force, {{0.1, 1, "N"}, {0, 1e-3, "mN"}}},
      {energy, {{0, 1, "J"}}},
      {pressure, {{1e4, 1e3, "kPa"}, {0, 1, "Pa"}}},
      {line_force, {{0, 1, "N/m"}}},
      {shear_stiffness, {{0, 1, "N/m/rad"}}},
      {softness, {{0, 1, "Pa/m"}}},
      {area_weight, {{0, 1e-3, "g/m^2"}}},
      {curvature, {{0, 1, "1/m"}}},
      {length / time, {{0, 1, "m/s"}}},
  };
  return all;
}

}  // namespace

std::string format_number(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  return text == "-0" ? "0" : text;
}

std::string format_quantity(double si, Dimension dim, bool percent) {
  if (dim.plain()) return percent ? format_number(si * 100) + " %" : format_number(si);
  // What lies below a tenth of a nanometre is rounding.
  if (dim == dimension::length && std::abs(si) < 1e-10) return "0 cm";
  for (const Preference& preference : preferences()) {
    if (preference.dimension != dim) continue;
    const double size = std::abs(si);
    for (const Choice& choice : preference.choices) {
      // A hair below the bound still belongs above it: 9.9999999 mm reads as 1 cm. Zero takes the first unit.
      const bool fits = size >= choice.from * (1 - 1e-6);
      if (!fits && size != 0) continue;
      return format_number(si / choice.factor) + " " + std::string(choice.symbol);
    }
  }
  return format_number(si) + " " + si_symbol(dim);
}

}  // namespace toile
