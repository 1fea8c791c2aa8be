// Names of another program as names of the language.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace toile {

/// A name as near as possible to `text`: what cannot stand in one becomes `_`; `fallback` where nothing is left.
std::string name_like(std::string_view text, std::string_view fallback);

/// Names of one block: a name that is taken already gets a number, from 2 on.
class Names {
 public:
  std::string take(const std::string& wanted);

 private:
  std::set<std::string> taken_;
};

}  // namespace toile
