// A module's reference, from its definitions and their `///` comments: `toile doc`.
#pragma once

#include <string>

#include "grammar/parse.hpp"

namespace toile::syntax {

/// As Markdown: what the module is for, then its definitions by kind in the order of the text, each with the way it is
/// called, what its comment says, what can be set of it, and its pieces with the names of their edges. Values (`let`)
/// stand there when they have a comment.
std::string reference(const Parsed& parsed, const Source& source, const std::string& module);

}  // namespace toile::syntax
