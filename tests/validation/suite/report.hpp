// The figures of the suite as a page.
#pragma once

#include <string>
#include <vector>

#include "tests/validation/suite/figures.hpp"

namespace toile::validation {

/// Markdown. Chapters take the places of those with their titles in the page as it stood; others of it stay. Pictures
/// are expected in the folder `validation` beside the page.
std::string page(const std::string& before, const std::vector<Chapter>& chapters);

}  // namespace toile::validation
