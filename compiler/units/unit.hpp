// Units as they are written behind a number: `cm`, `gf*cm/cm^2`, `mg/cm^2`, `%`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/units/dimension.hpp"

namespace toile {

struct Unit {
  double factor = 1;  // SI value of one unit
  Dimension dimension;
  bool percent = false;  // written in %, and better shown so
};

/// A simple or compound unit, `nullopt` when a part of it is unknown (see `unknown_unit_part`).
std::optional<Unit> parse_unit(std::string_view text);

/// The first part of a compound that is no unit: "ft" of "gf*ft".
std::string_view unknown_unit_part(std::string_view text);

/// All simple units, for suggestions.
const std::vector<std::string>& unit_names();

}  // namespace toile
