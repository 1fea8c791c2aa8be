// Size tables: the measurements of each size, of which one is chosen from outside.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

/// `sizes women(waist, hip) at M { ... }`: the name stands for the measurements of the chosen size.
void define_sizes(Session& session, Scope& scope, const syntax::Sizes& written);

/// `--size NAME` for a script without any table.
void report_unused_size(Session& session);

/// The sizes that every table has, in the order of the first.
std::vector<std::string> common_sizes(const Session& session);

}  // namespace toile
