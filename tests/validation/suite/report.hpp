// The figures of the suite as a page.
#pragma once

#include <string>
#include <vector>

#include "tests/validation/suite/figures.hpp"

namespace toile::validation {

/// Markdown. Pictures are expected in the folder `validation` beside the page.
std::string page(const std::vector<Chapter>& chapters);

}  // namespace toile::validation
