// The pages of docs/errors as embedded text: what a code means, a script that provokes it, and the script mended.
#pragma once

#include <string_view>
#include <vector>

namespace toile {

struct ErrorPage {
  std::string_view code;  // "E0201"
  std::string_view text;  // Markdown
};

/// Sorted by code.
const std::vector<ErrorPage>& error_pages();

}  // namespace toile
