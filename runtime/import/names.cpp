#include "runtime/import/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "grammar/words.hpp"

namespace toile {
namespace {

constexpr std::size_t longest_name = 80;
// Behind an edge's name these ask for one of its ends or sides.
constexpr std::array<std::string_view, 4> parts_of_edges{"start", "end", "drawn", "mirrored"};

bool is_taken_by_the_language(std::string_view word) {
  return syntax::is_reserved(word) || syntax::is_unit(word) ||
         std::ranges::find(parts_of_edges, word) != parts_of_edges.end();
}

}  // namespace

std::string name_like(std::string_view text, std::string_view fallback) {
  std::string name;
  for (const char c : text) {
    const bool is_kept = syntax::is_word_char(c);
    if (is_kept || !name.ends_with('_')) name += is_kept ? c : '_';
    if (name.size() == longest_name) break;
  }
  while (name.ends_with('_')) name.pop_back();
  if (name.empty()) return std::string(fallback);
  if (syntax::is_digit(name.front())) name.insert(0, "_");
  if (is_taken_by_the_language(name)) name += '_';
  return name;
}

std::string Names::take(const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; !taken_.insert(name).second; ++number) name = fmt::format("{}_{}", wanted, number);
  return name;
}

}  // namespace toile
