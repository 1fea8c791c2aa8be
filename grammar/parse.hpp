// Text to tree. Parsing is a pure function that cannot fail: what is not understood becomes Error nodes and errors.
#pragma once

#include <string>
#include <vector>

#include "grammar/source.hpp"
#include "grammar/tree.hpp"

namespace toile::syntax {

/// What was expected where the text stopped making sense. Prose is made of it by the compiler's diagnostics.
struct SyntaxError {
  enum class What {
    Unexpected,   // something else could have stood here
    Unclosed,     // a bracket, brace or quote (`opened`) that nothing closes before `span`
    TooDeep,      // expressions nested deeper than anyone writes
    BadToken,     // not the text of any token: a stray character, a broken escape, a colour of five digits, a NUL byte
    MissingUnit,  // a number with letters after it that are no unit; `span` holds the letters
  };
  What what = What::Unexpected;
  Span span;                          // the offending text (may be empty at the end of a line)
  Span opened;                        // for Unclosed: the bracket that was never closed
  std::vector<std::string> expected;  // names of what could have stood there, sorted, in garment words
};

struct Parsed {
  Tree tree;
  std::vector<SyntaxError> errors;
};

/// The tree of a script. Errors stand in the order of the text.
Parsed parse(const Source& source);

/// The tree of one expression alone, as in `--set flare=20cm`; its root is a File with the expression as its child.
Parsed parse_expression(const Source& source);

}  // namespace toile::syntax
