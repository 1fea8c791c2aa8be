#include "compiler/units/unit.hpp"

#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace toile {
namespace {

constexpr double standard_gravity = 9.80665;  // [m/s2] what makes a gram-force of a gram, by definition

const std::vector<std::pair<std::string_view, Unit>>& simple_units() {
  using namespace dimension;
  static const std::vector<std::pair<std::string_view, Unit>> units{
      {"um", {1e-6, length}},
      {"mm", {1e-3, length}},
      {"cm", {1e-2, length}},
      {"m", {1, length}},
      {"inch", {0.0254, length}},
      {"yd", {0.9144, length}},
      {"pt", {0.0254 / 72, length}},
      {"deg", {std::numbers::pi / 180, angle}},
      {"rad", {1, angle}},
      {"mg", {1e-6, mass}},
      {"g", {1e-3, mass}},
      {"kg", {1, mass}},
      {"mN", {1e-3, force}},
      {"cN", {1e-2, force}},
      {"N", {1, force}},
      {"gf", {1e-3 * standard_gravity, force}},
      {"kgf", {standard_gravity, force}},
      {"Pa", {1, pressure}},
      {"kPa", {1e3, pressure}},
      {"mmHg", {133.322387415, pressure}},
      {"J", {1, energy}},
      {"s", {1, time}},
      {"%", {0.01, number, true}},
  };
  return units;
}

/// One factor of a compound: a simple unit with an optional whole exponent of one digit.
std::optional<Unit> parse_factor(std::string_view text) {
  int exponent = 1;
  if (const std::size_t caret = text.find('^'); caret != std::string_view::npos) {
    const std::string_view digits = text.substr(caret + 1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc{} || end != digits.data() + digits.size() || exponent < 1 || exponent > 9) return {};
    text = text.substr(0, caret);
  }
  for (const auto& [name, unit] : simple_units()) {
    if (name != text) continue;
    return Unit{std::pow(unit.factor, exponent), power(unit.dimension, exponent), unit.percent && exponent == 1};
  }
  return std::nullopt;
}

struct Factor {
  std::string_view text;
  bool divides = false;
};

std::vector<Factor> factors(std::string_view text) {
  std::vector<Factor> parts;
  bool divides = false;
  while (true) {
    const std::size_t end = text.find_first_of("*/");
    parts.push_back({text.substr(0, end), divides});
    if (end == std::string_view::npos) return parts;
    divides = text[end] == '/';
    text = text.substr(end + 1);
  }
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  Unit result;
  const std::vector<Factor> parts = factors(text);
  for (const Factor& part : parts) {
    const std::optional<Unit> unit = parse_factor(part.text);
    if (!unit) return std::nullopt;
    result.factor = part.divides ? result.factor / unit->factor : result.factor * unit->factor;
    result.dimension = part.divides ? result.dimension / unit->dimension : result.dimension * unit->dimension;
    result.percent = unit->percent && parts.size() == 1;
  }
  return result;
}

std::string_view unknown_unit_part(std::string_view text) {
  for (const Factor& part : factors(text)) {
    if (!parse_factor(part.text)) return part.text;
  }
  return {};
}

const std::vector<std::string>& unit_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, unit] : simple_units()) all.emplace_back(name);
    return all;
  }();
  return names;
}

}  // namespace toile
