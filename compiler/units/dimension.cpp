#include "compiler/units/dimension.hpp"

#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace toile {

std::optional<Dimension> root(Dimension a) {
  if (a.length % 2 != 0 || a.mass % 2 != 0 || a.time % 2 != 0 || a.angle % 2 != 0) return std::nullopt;
  return Dimension{a.length / 2, a.mass / 2, a.time / 2, a.angle / 2};
}

std::string si_symbol(Dimension a) {
  const std::array<std::pair<std::string_view, int>, 4> bases{
      {{"kg", a.mass}, {"m", a.length}, {"rad", a.angle}, {"s", a.time}}};
  std::string above;
  std::string below;
  for (const auto& [symbol, exponent] : bases) {
    if (exponent == 0) continue;
    std::string& part = exponent > 0 ? above : below;
    part += exponent > 0 ? (part.empty() ? "" : "*") : "/";
    part += symbol;
    if (std::abs(exponent) > 1) part += "^" + std::to_string(std::abs(exponent));
  }
  return (above.empty() ? "1" : above) + below;
}

std::string describe(Dimension a) {
  using namespace dimension;
  static constexpr std::array<std::pair<Dimension, std::string_view>, 16> known{{
      {number, "a plain number"},
      {length, "a length"},
      {area, "an area"},
      {power(length, 3), "a volume"},
      {angle, "an angle"},
      {mass, "a mass"},
      {time, "a time"},
      {length / time, "a speed"},
      {force, "a force"},
      {energy, "an energy or a moment"},
      {pressure, "a pressure"},
      {line_force, "a force per width"},
      {softness, "a pressure per depth"},
      {area_weight, "a weight per area"},
      {shear_stiffness, "a shear stiffness"},
      {curvature, "a curvature"},
  }};
  for (const auto& [dim, words] : known) {
    if (dim == a) return std::string(words);
  }
  return "a quantity in " + si_symbol(a);
}

}  // namespace toile
