// One layout for all scripts: `toile fmt`.
//
// The layout follows from the words, the comments and the empty lines of a script alone. Statements stand one a line,
// two blanks deeper in each block; a line that would pass page_width columns is broken at its arguments, operators or
// commas. Neighbouring lines of one kind are set in columns. Comments stay with the words they stand at, and between
// statements one empty line is kept.
#pragma once

#include <string>

#include "grammar/parse.hpp"

namespace toile::syntax {

/// The script in its layout. `parsed` has no errors. Where the new text would not read as the same script, which no
/// text that anyone writes comes near, it is left as it is.
std::string format(const Parsed& parsed, const Source& source);

/// Whether two texts are one script: the same trees, words and comments, whatever the blanks between them.
bool same_script(const Parsed& a, const Source& a_source, const Parsed& b, const Source& b_source);

}  // namespace toile::syntax
