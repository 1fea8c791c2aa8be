// A cloth is measured on the KES or on FAST and the cantilever, property by property; the two are kept apart.
#pragma once

#include <map>
#include <string>

#include "compiler/evaluate/reporter.hpp"
#include "compiler/pattern/fabric_sheet.hpp"

namespace toile {

/// Rows written in one block, by name.
using WrittenRows = std::map<std::string, Location>;

/// What a block measures on one instrument replaces what the fabric that it varies has from the other. Rows of both for
/// one property are an error, E0413; false then.
bool of_one_instrument(Reporter& report, FabricSheet& sheet, const WrittenRows& rows);

/// Whether some cloth has all these rows: E0414 where an elongation does not grow with the force, where the curve says
/// too little, or where a strip on the bias is stiffer than any twisting stiffness makes it.
bool fit_together(Reporter& report, const FabricSheet& sheet, const WrittenRows& rows);

}  // namespace toile
