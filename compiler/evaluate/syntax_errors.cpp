#include "compiler/evaluate/syntax_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/session.hpp"
#include "compiler/evaluate/statement_forms.hpp"
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
  constexpr std::size_t most = 7;
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

/// A unit as others write it, or a word that may stand behind a number.
std::string meant_by(std::string_view text) {
  struct Other {
    std::string_view word, unit;
  };
  constexpr std::array others{Other{"in", "inch"},        Other{"inches", "inch"}, Other{"degrees", "deg"},
                              Other{"degree", "deg"},     Other{"percent", "%"},   Other{"millimetres", "mm"},
                              Other{"centimetres", "cm"}, Other{"points", "pt"},   Other{"yards", "yd"},
                              Other{"ply", "plies"}};
  for (const Other& other : others) {
    if (other.word == text) return "write `" + std::string(other.unit) + "`";
  }
  const std::vector<std::string> words{"mirrored", "plies", "held", "placed", "reversed"};
  return nearest(text, words) ? suggestion(text, words) : suggestion(text, unit_names());
}

Problem no_unit(const Source& source, FileId file, Span span) {
  const std::string_view text = source.slice(span);
  const std::string near = meant_by(text);
  return Problem("E0204", "`" + std::string(text) + "` is no unit")
      .at({file, span})
      .help(near.empty() ? "lengths are in um, mm, cm, m, inch, yd or pt, angles in deg or rad" : near);
}

/// Signs that look like one of the language's, or stand for one in other languages; and what is written instead.
struct Lookalike {
  std::string_view sign;
  std::string_view instead;
};
constexpr std::array lookalikes{
    Lookalike{";", "a statement ends with its line: leave the `;` out"},
    Lookalike{"#", "a comment begins with `//`, a colour has 3, 6 or 8 hexadecimal digits: `#1f3a5f`"},
    Lookalike{"'", "texts stand in double quotes: `\"front\"`"},
    Lookalike{"&", "write `and`"},
    Lookalike{"|", "write `or`"},
    Lookalike{"!", "write `not`"},
    Lookalike{"\u201c", "write `\"`"},
    Lookalike{"\u201d", "write `\"`"},
    Lookalike{"\u201e", "write `\"`"},
    Lookalike{"\u00ab", "write `\"`"},
    Lookalike{"\u00bb", "write `\"`"},
    Lookalike{"\u2018", "write `\"`"},
    Lookalike{"\u2019", "write `\"`"},
    Lookalike{"\u2212", "this is another sign that looks like a minus: write `-`"},
    Lookalike{"\u2013", "this is another sign that looks like a minus: write `-`"},
    Lookalike{"\u2014", "this is another sign that looks like a minus: write `-`"},
    Lookalike{"\u00d7", "write `*`"},
    Lookalike{"\u00b7", "write `*`"},
    Lookalike{"\u00f7", "write `/`"},
    Lookalike{"\u00b0", "write `deg`"},
    Lookalike{"\u2033", "write `inch`"},
    Lookalike{"\u2026", "write `...`"},
    Lookalike{"\u00a0", "this is a blank that keeps lines together: write an ordinary one"},
    Lookalike{"\u202f", "this is a blank that keeps lines together: write an ordinary one"},
    Lookalike{"\ufeff", "this is a byte order mark in the middle of the text: take it out"},
};

Problem unreadable(const Source& source, FileId file, Span span) {
  const std::string_view text = source.slice(span);
  const auto byte = static_cast<unsigned char>(text.empty() ? ' ' : text.front());
  const bool known = text.starts_with('"') || text.starts_with('#');
  if (byte >= 0x80 && text.size() == 1) {
    return Problem("E0004", fmt::format("the byte 0x{:02X} is no UTF-8 text", byte))
        .at({file, span})
        .help("save the file as UTF-8");
  }
  if (byte < 0x20 && !known) {
    return Problem("E0004", fmt::format("the byte 0x{:02X} cannot be read", byte)).at({file, span});
  }
  Problem problem("E0004", found_text(source, span) + " cannot be read");
  problem.at({file, span});
  const auto alike =
      std::ranges::find_if(lookalikes, [&](const Lookalike& each) { return text.starts_with(each.sign); });
  if (alike != lookalikes.end()) {
    problem.help(std::string(alike->instead));
  } else if (byte >= 0x80) {
    problem.help("names have the letters a-z and A-Z, digits and `_`");
  }
  return problem;
}

bool is_word(std::string_view text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0;
}

bool expects(const SyntaxError& error, std::string_view what) {
  return std::ranges::find(error.expected, what) != error.expected.end();
}

/// What was probably meant, from the word or sign found; empty when nothing stands out.
std::string meant(const Source& source, const SyntaxError& error) {
  const std::string_view all = source.text();
  const std::string_view found = source.slice(error.span);
  const std::size_t behind = std::min(all.find_first_not_of(" \t", error.span.end), all.size());
  const char next = behind < all.size() ? all[behind] : '\n';
  if (expects(error, "a name") && is_keyword(found)) {
    return fmt::format("`{}` is a word of the language: choose another name", found);
  }
  if (all.substr(error.span.begin).starts_with("/*")) return "a comment begins with `//` and ends with its line";
  const std::size_t before = all.substr(0, error.span.begin).find_last_not_of(' ');
  const bool in_braces = expects(error, "`}`") || (before != std::string_view::npos && all[before] == '{');
  if (in_braces && (found.empty() || found == "\"" || found == "}") &&
      all.substr(0, error.span.begin).rfind('"') != std::string_view::npos) {
    return "a value in a text stands in braces, `{length in cm}`; a brace that is meant is written `\\{`";
  }
  const std::string_view form = form_of_statement(all, error.span.begin);
  const bool chains = form.starts_with("sew") || form.starts_with("wear");
  if (found == "in" && chains && expects(error, "an operator")) {
    return "of a chain only the last edge may be a part: sew the others in seams of their own";
  }
  if (expects(error, "`:`") && !is_word(found)) return "an argument is given by its name with a colon: `waist: 68cm`";
  if (found == ":" && expects(error, "`=`")) return "what stands for a name follows behind `=`";
  if (found == "=" && expects(error, "an operator")) return "two values are compared with `==`";
  const bool decimal = found == "," && error.span.begin > 0 && error.span.end < all.size() &&
                       std::isdigit(static_cast<unsigned char>(all[error.span.begin - 1])) != 0 &&
                       std::isdigit(static_cast<unsigned char>(all[error.span.end])) != 0;
  const bool after_comma = error.span.begin > 1 && all[error.span.begin - 1] == ',' && !found.empty() &&
                           std::isdigit(static_cast<unsigned char>(found.front())) != 0 &&
                           std::isdigit(static_cast<unsigned char>(all[error.span.begin - 2])) != 0;
  if (decimal || after_comma) return "a decimal has a point: `3.5cm`";
  const bool compares =
      found == "<" || found == ">" || found == "<=" || found == ">=" || found == "==" || found == "!=";
  if (compares) return "comparisons do not chain: `a < b and b < c`";
  const std::vector<std::string>& statements = statement_names();
  const bool begins = std::ranges::find(statements, found) != statements.end();
  if (begins && expects(error, "the end of the line")) return "one statement a line";
  if (is_word(found)) {
    std::vector<std::string> words;
    for (const std::string& each : error.expected) {
      if (each.size() > 2 && each.front() == '`') words.push_back(each.substr(1, each.size() - 2));
    }
    if (const auto near = nearest(found, words)) return "did you mean `" + *near + "`?";
    if (next == '=' && !begins) return fmt::format("a value is named by `let {} = ...`", found);
  }
  return "";
}

Problem unexpected(const Source& source, FileId file, const SyntaxError& error) {
  const std::string found = found_text(source, error.span);
  const std::string expected = expected_text(error.expected);
  std::string message = found.empty() ? "the text ends too early here" : found + " does not belong here";
  if (!expected.empty()) message = "expected " + expected + (found.empty() ? "" : ", not " + found);
  Problem problem("E0001", message);
  problem.at({file, error.span}, expected.empty() ? "" : "expected " + expected);
  if (const std::string help = meant(source, error); !help.empty()) return problem.help(help);
  const std::string_view form = form_of_statement(source.text(), error.span.begin);
  if (!form.empty()) return problem.help(fmt::format("it is written: {}", form));
  if (const auto near = nearest(source.slice(error.span), statement_names())) {
    problem.help("did you mean `" + *near + "`?");
  }
  return problem;
}

Problem explained(const Source& source, FileId file, const SyntaxError& error) {
  const Location at{file, error.span};
  const std::string_view found_word = source.slice(error.span);
  switch (error.what) {
    case SyntaxError::What::Unclosed:
      return Problem("E0002", found_text(source, error.opened) + " is never closed")
          .at({file, error.opened}, "opened here")
          .also(at, "not closed by here");
    case SyntaxError::What::TooDeep:
      return Problem("E0003", "brackets are nested too deeply here").at(at);
    case SyntaxError::What::BadToken:
      return unreadable(source, file, error.span);
    case SyntaxError::What::MissingUnit:
      return no_unit(source, file, error.span);
    case SyntaxError::What::Unexpected:
      if (follows_number(source.text(), error.span) && !is_keyword(found_word)) {
        return no_unit(source, file, error.span);
      }
      if (expects(error, "a unit") && is_word(found_word)) return no_unit(source, file, error.span);
      break;
  }
  return unexpected(source, file, error);
}

/// How many braces are opened in the text and not closed again; below zero where more are closed.
int open_braces(std::string_view text) {
  int open = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '"') {
      for (++at; at < text.size() && text[at] != '"' && text[at] != '\n'; ++at) at += text[at] == '\\' ? 1 : 0;
    } else if (text.substr(at).starts_with("//")) {
      at = std::min(text.find('\n', at), text.size());
    } else {
      open += text[at] == '{' ? 1 : text[at] == '}' ? -1 : 0;
    }
  }
  return open;
}

/// A statement that is one of the language's, but not where it stands.
bool is_out_of_place(const Source& source, const SyntaxError& error) {
  if (error.what != SyntaxError::What::Unexpected) return false;
  const std::string_view found = source.slice(error.span);
  return found == "}" || found == "line" || std::ranges::find(statement_names(), found) != statement_names().end();
}

/// A text in another encoding is wrong as a whole, not at each of its bytes.
std::optional<Problem> other_encoding(const Source& source, FileId file) {
  const std::string_view text = source.text();
  const bool marked = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  const bool halves = text.size() >= 4 && (text[1] == '\0' || text[0] == '\0') && text[2] != text[3] &&
                      (text[3] == '\0' || text[2] == '\0');
  if (!marked && !halves) return std::nullopt;
  return Problem("E0004", "this text is UTF-16").at({file, {0, 2}}).help("save the file as UTF-8");
}

}  // namespace

Diagnostic syntax_diagnostic(const SyntaxError& error, const Source& source, FileId file) {
  return explained(source, file, error).diagnostic();
}

void report_syntax_errors(Session& session, const Module& module) {
  const Source& source = session.sources[module.file];
  if (module.parsed.errors.empty()) return;
  if (const auto encoding = other_encoding(source, module.file)) return session.report.add(*encoding);
  // One brace too many closes a block too early, and then all that follows stands in the wrong one.
  const bool closed_early = open_braces(source.text()) < 0;
  bool told = false;
  for (const SyntaxError& error : module.parsed.errors) {
    const bool follows = closed_early && is_out_of_place(source, error);
    if (follows && std::exchange(told, true)) continue;
    Diagnostic diagnostic = syntax_diagnostic(error, source, module.file);
    if (follows) diagnostic.help = "a `}` before it closes its block too early, or is one too many";
    session.report.add(std::move(diagnostic));
  }
}

}  // namespace toile
