// From the grammar's events to the tree.
#pragma once

#include <string_view>
#include <vector>

#include "grammar/record.hpp"
#include "grammar/tree.hpp"

namespace toile::syntax {

/// The lossless tree over the whole text: the events under a File node, and white space and comments as tokens in the
/// gaps between theirs. Trivia belong to the innermost node that has tokens on both sides of them.
Tree build_tree(std::string_view text, const std::vector<Event>& events);

}  // namespace toile::syntax
