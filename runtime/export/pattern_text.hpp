// A developed pattern as the text of a script, for a person to go on with.
#pragma once

#include <string>

#include "runtime/develop/redraw.hpp"

namespace toile {

/// A dart of a piece that is drawn on a body, as a script says it.
std::string slit_text(const DraftDart& dart);

/// One garment with its cloth; `notes` stand at its head as comments; what it cannot say of the original (where it is
/// worn) is left out. `source` names the script that it was developed by. In the layout of no one: `toile fmt` makes it
/// that.
std::string pattern_text(const Redrawn& redrawn, const std::string& source, const std::vector<std::string>& notes = {});

}  // namespace toile
