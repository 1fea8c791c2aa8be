#include "grammar/words.hpp"

#include <algorithm>
#include <array>

namespace toile::syntax {
namespace {

constexpr std::array<std::string_view, 21> reserved{"and",  "as", "at",     "else", "false", "fn",   "for",
                                                    "from", "if", "import", "in",   "let",   "not",  "of",
                                                    "on",   "or", "param",  "then", "to",    "true", "with"};

constexpr std::array<std::string_view, 22> units{"um", "mm", "cm", "m", "inch", "yd",  "pt", "deg", "rad",  "mg", "g",
                                                 "kg", "mN", "cN", "N", "gf",   "kgf", "Pa", "kPa", "mmHg", "J",  "s"};

std::optional<Kind> statement_keyword(std::string_view word) {
  for (int i = static_cast<int>(Kind::KwImport); i <= static_cast<int>(Kind::KwExpect); ++i) {
    if (spelling(static_cast<Kind>(i)) == word) return static_cast<Kind>(i);
  }
  return std::nullopt;
}

}  // namespace

std::string_view word_at(std::string_view text, std::size_t offset) {
  std::size_t end = offset;
  while (end < text.size() && is_word_char(text[end])) ++end;
  return text.substr(offset, end - offset);
}

bool is_reserved(std::string_view word) {
  return std::ranges::find(reserved, word) != reserved.end();
}

bool is_unit(std::string_view word) {
  return std::ranges::find(units, word) != units.end();
}

std::optional<Kind> statement_at(std::string_view text, std::size_t offset) {
  const std::string_view word = word_at(text, offset);
  const auto keyword = statement_keyword(word);
  if (!keyword) return std::nullopt;
  const std::size_t gap = offset + word.size();
  const std::size_t next = std::min(text.find_first_not_of(" \t", gap), text.size());
  if (next == gap || next == text.size()) return std::nullopt;
  if (text[next] == '"') return keyword;
  if (text[next] == '{') return *keyword == Kind::KwOutline ? keyword : std::nullopt;
  if (!is_letter(text[next])) return std::nullopt;
  const std::string_view follower = word_at(text, next);
  const bool belongs = follower == "at" || follower == "from" || follower == "not" || follower == "if";
  return is_reserved(follower) && !belongs ? std::nullopt : keyword;
}

}  // namespace toile::syntax
