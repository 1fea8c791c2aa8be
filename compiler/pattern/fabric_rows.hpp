// The rows of a cloth's sheet: one table for what reads scripts and for what writes them.
#pragma once

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "compiler/pattern/fabric_sheet.hpp"

namespace toile {

/// A row of the sheet: its name and unit there, the unit's size [SI], where it goes, and the bounds of what cloths,
/// leathers and films have, tenfold [SI]: beyond them a unit or a digit is wrong.
struct FabricRow {
  std::string_view name, unit;
  double size;
  std::variant<std::optional<WarpWeft> FabricSheet::*, std::optional<double> FabricSheet::*> place;
  double least, most;
};

/// All rows with numbers, in the order in which they are written.
const std::vector<FabricRow>& fabric_rows();

}  // namespace toile
