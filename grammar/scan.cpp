#include "grammar/scan.hpp"

#include "grammar/words.hpp"

namespace toile::syntax {
namespace {

std::uint32_t size_of(std::string_view text) {
  return static_cast<std::uint32_t>(text.size());
}

bool comment_at(std::string_view text, std::uint32_t at) {
  return text.substr(at, 2) == "//";
}

/// The mark that some editors put at the beginning of a file; white space to us.
std::uint32_t byte_order_mark(std::string_view text, std::uint32_t at) {
  return at == 0 && text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

std::uint32_t line_end(std::string_view text, std::uint32_t at) {
  const std::size_t end = text.find('\n', at);
  return end == std::string_view::npos ? size_of(text) : static_cast<std::uint32_t>(end);
}

/// Brackets, quotes and lines passed while skipping.
class Skipper {
 public:
  Skipper(std::string_view text, std::uint32_t mistake, SkipTo to) : text_(text), mistake_(mistake), to_(to) {}

  bool stops(std::uint32_t at) const {
    if (at < mistake_) return false;
    const char c = text_[at];
    if (c == '\n' && (new_statement(at + 1) || opened_nothing(at))) return true;
    if (braces_ > 0) return false;
    if (c == '}' || (c == '{' && to_ == SkipTo::Block)) return true;
    return brackets_ == 0 && (c == '\n' || (c == ',' && to_ == SkipTo::Comma));
  }

  /// Past the character, text or comment at `at`.
  std::uint32_t step(std::uint32_t at) {
    const char c = text_[at];
    if (c == '"') return quote_end(text_, at);
    if (comment_at(text_, at)) return line_end(text_, at);
    if (c == '(' || c == '[') ++brackets_;
    if ((c == ')' || c == ']') && brackets_ > 0) --brackets_;
    if (c == '{' && braces_++ == 0) brace_ = at;
    if (c == '}' && braces_ > 0) --braces_;
    return at + 1;
  }

 private:
  // In a block that is being skipped every line begins a statement; only one that no block can hold, unindented, ends
  // it.
  bool new_statement(std::uint32_t line) const {
    const std::uint32_t at = braces_ > 0 ? line : skip_blanks(text_, line);
    const auto keyword = statement_at(text_, at);
    return keyword && (braces_ == 0 || (statement_word(*keyword) & file_words) != 0);
  }

  // A brace at the end of its line with nothing behind it that is indented deeper: it slipped in.
  bool opened_nothing(std::uint32_t line_break) const {
    if (braces_ != 1 || skip_blanks(text_, brace_ + 1) != line_break) return false;
    const std::uint32_t next = skip_lines(text_, line_break);
    const auto column = [&](std::uint32_t at) {
      const std::size_t before = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
      const std::size_t line = before == std::string_view::npos ? 0 : before + 1;
      return std::min(text_.find_first_not_of(" \t", line), text_.size()) - line;
    };
    return next < text_.size() && text_[next] != '}' && column(next) <= column(brace_);
  }

  std::string_view text_;
  std::uint32_t mistake_;
  SkipTo to_;
  int brackets_ = 0;
  int braces_ = 0;
  std::uint32_t brace_ = 0;  // the outermost of those that are open
};

}  // namespace

std::uint32_t skip_blanks(std::string_view text, std::uint32_t at) {
  at += byte_order_mark(text, at);
  while (at < text.size() && is_blank(text[at])) ++at;
  return at < text.size() && comment_at(text, at) ? line_end(text, at) : at;
}

std::uint32_t skip_lines(std::string_view text, std::uint32_t at) {
  at = skip_blanks(text, at);
  while (at < text.size() && text[at] == '\n') at = skip_blanks(text, at + 1);
  return at;
}

Trivia trivia_at(std::string_view text, std::uint32_t at) {
  const auto crlf_or_lf = [&](std::uint32_t i) { return text[i] == '\n' || text.substr(i, 2) == "\r\n"; };
  std::uint32_t end = at + byte_order_mark(text, at);
  if (crlf_or_lf(at)) return {Kind::Newline, {at, at + (text[at] == '\n' ? 1u : 2u)}};
  if (comment_at(text, at)) {
    end = line_end(text, at);
    if (end < text.size() && end > at && text[end - 1] == '\r') --end;
    return {text.substr(at, 3) == "///" ? Kind::DocComment : Kind::Comment, {at, end}};
  }
  while (end < text.size() && is_blank(text[end]) && !crlf_or_lf(end)) ++end;
  return {Kind::Space, {at, end}};
}

std::uint32_t quote_end(std::string_view text, std::uint32_t at) {
  for (std::uint32_t i = at + 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == '"') return i + 1;
    if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] != '\n') ++i;
  }
  return line_end(text, at);
}

std::uint32_t code_point_length(std::string_view text, std::uint32_t at) {
  const auto byte = [&](std::uint32_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(at);
  if (lead < 0x80) return 1;
  const std::uint32_t length = lead >= 0xc2 && lead <= 0xdf ? 2 : lead >= 0xe0 && lead <= 0xef ? 3 : 4;
  if (lead < 0xc2 || lead > 0xf4 || at + length > text.size()) return 0;
  for (std::uint32_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0u) != 0x80) return 0;
  }
  // Overlong forms, surrogates and what lies beyond U+10FFFF show in the second byte.
  const unsigned second = byte(at + 1);
  const bool wrong = (lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
                     (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f);
  return wrong ? 0 : length;
}

Span lexeme_at(std::string_view text, std::uint32_t at) {
  if (at >= text.size() || text[at] == '\n' || text.substr(at, 2) == "\r\n") return {at, at};
  const char c = text[at];
  if (c == '"') return {at, quote_end(text, at)};
  if (is_word_char(c) || c == '#') {
    std::uint32_t end = at + 1;
    const auto decimal = [&] {
      return is_digit(c) && text[end] == '.' && end + 1 < text.size() && is_digit(text[end + 1]);
    };
    while (end < text.size() && (is_word_char(text[end]) || decimal())) ++end;
    return {at, end};
  }
  if (text.substr(at, 3) == "...") return {at, at + 3};
  const std::string_view pair = text.substr(at, 2);
  if (pair == "<=" || pair == ">=" || pair == "==" || pair == "!=" || pair == "..") return {at, at + 2};
  const std::uint32_t length = code_point_length(text, at);
  return {at, at + (length > 0 ? length : 1)};
}

Skip skip_mistake(std::string_view text, std::uint32_t from, std::uint32_t mistake, SkipTo to) {
  Skipper skipper(text, mistake, to);
  const std::uint32_t begin = skip_lines(text, from);
  std::uint32_t end = begin;
  std::uint32_t at = from;
  while (at < text.size() && !skipper.stops(at)) {
    const bool significant = !is_blank(text[at]) && text[at] != '\n' && !comment_at(text, at);
    at = skipper.step(at);
    if (significant) end = at;
  }
  return {{begin < end ? begin : from, begin < end ? end : from}, at};
}

}  // namespace toile::syntax
