// The registry of diagnostics: every code a user may meet, with its title and what it means (`toile explain E0201`).
#pragma once

#include <string_view>
#include <vector>

namespace toile {

struct CodeEntry {
  std::string_view code;         // "E0201"
  std::string_view title;        // "dimensions that do not agree"
  std::string_view explanation;  // a paragraph or two, with an example
};

/// In the order of the codes.
const std::vector<CodeEntry>& code_registry();
/// Null for a code that does not exist.
const CodeEntry* find_code(std::string_view code);

}  // namespace toile
