// Where a script's tokens stand: the tree as a document. Nothing but the tokens, the comments between them and the
// empty lines between statements counts; how the lines were broken before does not.
#pragma once

#include "grammar/format/document.hpp"
#include "grammar/tree.hpp"

namespace toile::syntax {

/// Of a tree without errors. Views in the document are of the source's text.
Doc lay_out(const Tree& tree, const Source& source);

}  // namespace toile::syntax
