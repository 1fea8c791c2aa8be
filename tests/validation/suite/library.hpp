// The cloths of the standard library.
#pragma once

#include <string>

#include "compiler/pattern/fabric_sheet.hpp"

namespace toile::validation {

FabricSheet fabric_called(const std::string& name);

}  // namespace toile::validation
