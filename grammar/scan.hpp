// Reading over text without understanding it: white space and comments, rough tokens for messages, the place where
// the parser can catch on again after a mistake.
#pragma once

#include <string_view>
#include <vector>

#include "grammar/kinds.hpp"
#include "grammar/source.hpp"

namespace toile::syntax {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// Past blanks and a comment, up to the end of the line at most.
std::uint32_t skip_blanks(std::string_view text, std::uint32_t at);

/// Past blanks, comments and line ends.
std::uint32_t skip_lines(std::string_view text, std::uint32_t at);

/// The one token of white space or comment at `at`, where there is one.
struct Trivia {
  Kind kind;
  Span span;
};
Trivia trivia_at(std::string_view text, std::uint32_t at);

/// The text that a person would point at: a word, a number with its unit, a text in quotes, an operator or a character.
/// Empty at the end of a line.
Span lexeme_at(std::string_view text, std::uint32_t at);

/// The end of the text in quotes that begins at `at`: past its closing quote, or at the end of the line.
std::uint32_t quote_end(std::string_view text, std::uint32_t at);

/// The length of the UTF-8 sequence at `at`, or 0 if it is none.
std::uint32_t code_point_length(std::string_view text, std::uint32_t at);

struct Skip {
  Span skipped;              // what is given up, without white space around it; may be empty
  std::uint32_t resume = 0;  // where to go on
};

/// What may end a skip besides a line end and a closing brace.
enum class SkipTo { Line, Block, Comma };

/// From `from` past `mistake` to the end of the line (brackets and blocks that open on the way are skipped whole), to a
/// closing brace, or to a line that begins a statement.
Skip skip_mistake(std::string_view text, std::uint32_t from, std::uint32_t mistake, SkipTo to);

}  // namespace toile::syntax
