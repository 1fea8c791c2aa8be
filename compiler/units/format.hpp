// Quantities as people expect to read them: lengths in cm, angles in degrees.
#pragma once

#include <string>

#include "compiler/units/dimension.hpp"

namespace toile {

/// The value of a quantity in SI with at most six significant digits and a unit that suits its size: "68 cm", "0.3 mm",
/// "12 deg", "4.2 %" (a plain number with `percent`), "1.25 N/m".
std::string format_quantity(double si, Dimension dimension, bool percent = false);

/// A number with at most `digits` significant digits and no trailing zeros; never "-0".
std::string format_number(double value, int digits = 6);

}  // namespace toile
