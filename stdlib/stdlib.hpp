// The standard library's modules as embedded text.
#pragma once

#include <string_view>
#include <vector>

namespace toile {

struct Module {
  std::string_view name;  // "bodies"
  std::string_view text;
};

/// Sorted by name.
const std::vector<Module>& stdlib_modules();

}  // namespace toile
