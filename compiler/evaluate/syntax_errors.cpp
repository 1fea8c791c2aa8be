#include "compiler/evaluate/syntax_errors.hpp"

#include <algorithm>
#include <cctype>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/session.hpp"
#include "compiler/units/unit.hpp"
#include "grammar/kinds.hpp"

namespace toile {
namespace {

using syntax::SyntaxError;

std::string found_text(const Source& source, Span span) {
  std::string_view text = source.slice(span);
  text = text.substr(0, text.find('\n'));
  constexpr std::size_t longest = 24;
  if (text.empty()) return "";
  return text.size() > longest ? "`" + std::string(text.substr(0, text.find(' ', 1))).substr(0, longest) + "`"
                               : "`" + std::string(text) + "`";
}

std::string expected_text(const std::vector<std::string>& expected) {
  constexpr std::size_t most = 6;
  if (expected.empty() || expected.size() > most) return "";
  std::string text;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (i > 0) text += i + 1 == expected.size() ? " or " : ", ";
    text += expected[i];
  }
  return text;
}

bool is_keyword(std::string_view text) {
  for (int i = 0; i < syntax::kind_count; ++i) {
    const auto kind = static_cast<syntax::Kind>(i);
    if (syntax::is_keyword(kind) && syntax::spelling(kind) == text) return true;
  }
  return false;
}

/// A word right behind a number was meant as its unit.
bool follows_number(std::string_view text, Span span) {
  const std::string_view before = text.substr(0, span.begin);
  const std::size_t last = before.find_last_not_of(' ');
  const bool word = span.begin < text.size() && std::isalpha(static_cast<unsigned char>(text[span.begin])) != 0;
  return word && last != std::string_view::npos && std::isdigit(static_cast<unsigned char>(before[last])) != 0;
}

Problem no_unit(const Source& source, FileId file, Span span) {
  const std::string_view text = source.slice(span);
  return Problem("E0204", "`" + std::string(text) + "` is no unit")
      .at({file, span})
      .help(suggestion(text, unit_names()));
}

Problem unexpected(const Source& source, FileId file, const SyntaxError& error) {
  const std::string found = found_text(source, error.span);
  const std::string expected = expected_text(error.expected);
  std::string message = found.empty() ? "the text ends too early here" : found + " does not belong here";
  if (!expected.empty()) message = "expected " + expected + (found.empty() ? "" : ", not " + found);
  Problem problem("E0001", message);
  problem.at({file, error.span}, expected.empty() ? "" : "expected " + expected);
  const std::string_view text = source.slice(error.span);
  const bool name_wanted = std::find(error.expected.begin(), error.expected.end(), "a name") != error.expected.end();
  if (name_wanted && is_keyword(text)) {
    problem.help("`" + std::string(text) + "` is a word of the language: choose another name");
  }
  return problem;
}

Problem explained(const Source& source, FileId file, const SyntaxError& error) {
  const Location at{file, error.span};
  const std::string found = found_text(source, error.span);
  const std::string_view found_word = source.slice(error.span);
  switch (error.what) {
    case SyntaxError::What::Unclosed:
      return Problem("E0002", found_text(source, error.opened) + " is never closed")
          .at({file, error.opened}, "opened here")
          .also(at, "not closed by here");
    case SyntaxError::What::TooDeep:
      return Problem("E0003", "brackets are nested too deeply here").at(at);
    case SyntaxError::What::BadToken:
      return Problem("E0004", found + " cannot be read").at(at);
    case SyntaxError::What::MissingUnit:
      return no_unit(source, file, error.span);
    case SyntaxError::What::Unexpected:
      if (follows_number(source.text(), error.span) && !is_keyword(found_word)) {
        return no_unit(source, file, error.span);
      }
      break;
  }
  return unexpected(source, file, error);
}

}  // namespace

Diagnostic syntax_diagnostic(const SyntaxError& error, const Source& source, FileId file) {
  return explained(source, file, error).diagnostic();
}

void report_syntax_errors(Session& session, const Module& module) {
  const Source& source = session.sources[module.file];
  for (const SyntaxError& error : module.parsed.errors) {
    session.report.add(syntax_diagnostic(error, source, module.file));
  }
}

}  // namespace toile
