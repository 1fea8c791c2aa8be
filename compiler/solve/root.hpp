// The root of one equation in one unknown, by bracketing: it cannot run away, and what it finds lies in the range.
#pragma once

#include <functional>
#include <optional>

namespace toile {

/// The value of a function at a place, or nothing where it has none.
using Function = std::function<std::optional<double>(double)>;

/// A stretch whose ends have values of different sign (or zero).
struct Bracket {
  double low = 0;
  double high = 0;
  double at_low = 0;  // the function there
  double at_high = 0;
};

/// A place within the bracket where the function is zero or changes its sign, to the last bits of a double: Brent's
/// method, which interpolates where that is safe and halves the bracket where not. Nothing when the function has no
/// value on the way.
std::optional<double> root_within(const Function& function, Bracket bracket);

}  // namespace toile
