#include "grammar/record.hpp"

#include <algorithm>
#include <utility>

#include "grammar/scan.hpp"

namespace toile::syntax {
namespace {

using What = SyntaxError::What;

std::vector<std::string> sorted_words(const Record::Expected& expected) {
  std::vector<std::string> words;
  for (int i = 0; i < kind_count; ++i) {
    const std::string_view word = expectation(static_cast<Kind>(i));
    if (expected.test(static_cast<std::size_t>(i)) && !word.empty()) words.emplace_back(word);
  }
  std::ranges::sort(words);
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

bool is_closed_quote(std::string_view quoted) {
  if (quoted.size() < 2 || quoted.back() != '"') return false;
  std::size_t backslashes = 0;
  while (quoted[quoted.size() - 2 - backslashes] == '\\') ++backslashes;
  return backslashes % 2 == 0;
}

Span bad_escape(std::string_view text, Span quoted) {
  for (std::uint32_t i = quoted.begin + 1; i + 1 < quoted.end; ++i) {
    if (text[i] != '\\') continue;
    const char escaped = text[i + 1];
    if (escaped != '"' && escaped != '\\' && escaped != 'n') return {i, i + 2};
    ++i;
  }
  return quoted;
}

constexpr std::string_view known_signs = "()[]{},:=.+-*/^<>%\"#";

/// Sees whether the text at the mistake could be a token anywhere, and says what is wrong with it if not.
void judge_token(std::string_view text, SyntaxError& error) {
  const Span span = error.span;
  if (span.begin == span.end) return;
  const std::string_view lexeme = text.substr(span.begin, span.end - span.begin);
  const bool value_expected = std::ranges::find(error.expected, expectation(Kind::NameRef)) != error.expected.end();
  if (lexeme[0] == '"' && value_expected) {
    if (is_closed_quote(lexeme)) {
      error.what = What::BadToken;
      error.span = bad_escape(text, span);
      error.expected = {"`\\\"`", "`\\\\`", "`\\n`"};
    } else {
      error.what = What::Unclosed;
      error.opened = {span.begin, span.begin + 1};
      error.span = {span.end, span.end};
      error.expected = {"`\"`"};
    }
  } else if (lexeme[0] == '#') {
    error.what = What::BadToken;
    error.expected = {std::string(expectation(Kind::Hex))};
  } else if (is_digit(lexeme[0]) && value_expected) {
    const std::size_t letters = std::min(lexeme.find_first_not_of("0123456789."), lexeme.size());
    if (letters == lexeme.size()) return;
    error.what = What::MissingUnit;
    error.span.begin = span.begin + static_cast<std::uint32_t>(letters);
    error.expected = {std::string(expectation(Kind::Unit))};
  } else if (!is_word_char(lexeme[0]) && known_signs.find(lexeme[0]) == std::string_view::npos && lexeme != "!=") {
    error.what = What::BadToken;
  }
}

}  // namespace

void Record::close(Kind kind, std::uint32_t first) {
  if (first == size()) return;
  events_.push_back({kind, {events_[first].span.begin, end()}, first});
}

void Record::expect(Kind kind, std::uint32_t at) {
  if (at < furthest_.at) return;
  if (at > furthest_.at || furthest_.expected.none()) furthest_ = {at, end(), bracket, {}};
  furthest_.expected.set(static_cast<std::size_t>(kind));
}

void Record::expect_instead(Kind kind, std::uint32_t at, const Expected& before) {
  if (furthest_.at > at) return;
  furthest_ = {at, end(), bracket, before};
  furthest_.expected.set(static_cast<std::size_t>(kind));
}

bool Record::allows(int depth_or_height, std::uint32_t at) {
  if (depth_or_height <= max_depth) return true;
  too_deep_ = std::min(too_deep_, at);
  return false;
}

SyntaxError Record::failure(std::uint32_t begin) const {
  SyntaxError error;
  if (too_deep_ != nowhere) {
    error.what = What::TooDeep;
    error.span = lexeme_at(text_, too_deep_);
    return error;
  }
  error.span = lexeme_at(text_, furthest_.at);
  error.expected = sorted_words(furthest_.expected);

  // A statement that breaks off is wrong at the end of its own line, not at the beginning of the next one.
  const bool inside = furthest_.before > begin;
  const std::string_view gap = text_.substr(furthest_.before, furthest_.at - furthest_.before);
  const bool ended = furthest_.at == text_.size() || text_[furthest_.at] == '}' || text_[furthest_.at] == '\n';
  const bool breaks_off = ended || statement_at(text_, furthest_.at) || furthest_.bracket == nowhere;
  if (inside && breaks_off && (ended || gap.find('\n') != std::string_view::npos)) {
    error.span = {furthest_.before, furthest_.before};
  }
  const bool could_close = furthest_.expected.test(static_cast<std::size_t>(Kind::RightParen)) ||
                           furthest_.expected.test(static_cast<std::size_t>(Kind::RightBracket));
  if (furthest_.bracket != nowhere && error.span.begin == error.span.end && could_close) {
    error.what = What::Unclosed;
    error.opened = {furthest_.bracket, furthest_.bracket + 1};
    return error;
  }
  judge_token(text_, error);
  return error;
}

std::uint32_t Record::report_failure(std::uint32_t begin) {
  SyntaxError error = failure(begin);
  const std::uint32_t place = error.span.begin;
  report(std::move(error));
  furthest_ = {};
  too_deep_ = nowhere;
  return place;
}

void Record::report(SyntaxError error) {
  const bool news = errors_.empty() || errors_.back().span.begin != error.span.begin;
  if (news) errors_.push_back(std::move(error));
}

}  // namespace toile::syntax
