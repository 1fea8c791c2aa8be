// Which words mean what: statements, units, and the few that cannot name a value.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "grammar/kinds.hpp"

namespace toile::syntax {

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_word_char(char c) {
  return is_letter(c) || is_digit(c);
}

/// The letters, digits and underscores from `offset` on; may be empty, may begin with a digit.
std::string_view word_at(std::string_view text, std::size_t offset);

/// Words that are never the name of a value: `if`, `to`, `let`, … All others can be, though they may be keywords
/// elsewhere.
bool is_reserved(std::string_view word);

/// cm, kgf, mmHg, …; `%` is no word and not among them.
bool is_unit(std::string_view word);

/// A set of the words that begin statements.
using StatementWords = std::uint64_t;

constexpr StatementWords statement_word(Kind keyword) {
  return StatementWords{1} << (static_cast<int>(keyword) - static_cast<int>(Kind::KwImport));
}
template <typename... Kinds>
constexpr StatementWords statement_words(Kinds... keywords) {
  return (statement_word(keywords) | ... | StatementWords{0});
}

inline constexpr StatementWords file_words =
    statement_words(Kind::KwImport, Kind::KwParam, Kind::KwLet, Kind::KwFn, Kind::KwSolve, Kind::KwFabric,
                    Kind::KwTextile, Kind::KwSizes, Kind::KwBody, Kind::KwGarment, Kind::KwPiece, Kind::KwDrape,
                    Kind::KwDevelop, Kind::KwRender, Kind::KwExport, Kind::KwPrint, Kind::KwExpect, Kind::KwAllow);
inline constexpr StatementWords garment_words =
    statement_words(Kind::KwLet, Kind::KwParam, Kind::KwFn, Kind::KwSolve, Kind::KwPiece, Kind::KwSew, Kind::KwWear,
                    Kind::KwArrange, Kind::KwAllow);
inline constexpr StatementWords piece_words =
    statement_words(Kind::KwLet, Kind::KwSolve, Kind::KwOutline, Kind::KwHole, Kind::KwFold, Kind::KwCut, Kind::KwGrain,
                    Kind::KwDart, Kind::KwNotch, Kind::KwPivot, Kind::KwSpread, Kind::KwPleat, Kind::KwMark,
                    Kind::KwDrill, Kind::KwButtonhole, Kind::KwButton, Kind::KwAllowance, Kind::KwLabel, Kind::KwAllow);
/// What may stand under the `for` of a piece.
inline constexpr StatementWords repeated_words =
    statement_words(Kind::KwDart, Kind::KwNotch, Kind::KwSpread, Kind::KwPleat, Kind::KwMark, Kind::KwDrill,
                    Kind::KwButtonhole, Kind::KwButton);

/// The statement that seems to begin at `offset`: its keyword followed by a name, a text or the like, as no expression,
/// row or edge would go on. Used to notice that a bracket or block was not closed.
std::optional<Kind> statement_at(std::string_view text, std::size_t offset);

}  // namespace toile::syntax
