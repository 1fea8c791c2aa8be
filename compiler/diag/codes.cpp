#include "compiler/diag/codes.hpp"

namespace toile {

const std::vector<CodeEntry>& code_registry() {
  static const std::vector<CodeEntry> registry{
#define TOILE_CODE(code, title, explanation) {#code, title, explanation},
#include "compiler/diag/codes.def"
#undef TOILE_CODE
  };
  return registry;
}

const CodeEntry* find_code(std::string_view code) {
  for (const CodeEntry& entry : code_registry()) {
    if (entry.code == code) return &entry;
  }
  return nullptr;
}

}  // namespace toile
