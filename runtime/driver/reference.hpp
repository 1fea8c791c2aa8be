// `toile doc`: the reference of a module.
#pragma once

#include <string>

#include "runtime/driver/workroom.hpp"

namespace toile {

/// Prints the reference of a module of the standard library, or of a script when `module` is the path of one; without
/// a name, the names of the library's modules.
Outcome document_module(const std::string& module, Listener& listener);

}  // namespace toile
