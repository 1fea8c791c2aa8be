// What Toile's grammar is put together from, besides PEGTL's own rules: tokens and nodes that are written to the
// record, and statements and blocks that survive mistakes.
#pragma once

#include <algorithm>

#include "grammar/reader.hpp"

namespace toile::syntax {

/// A leaf of the tree, after the gap before it.
template <Kind K, typename... Rules>
struct token {
  using rule_t = token;
  using subs_t = pegtl::type_list<Rules...>;

  static bool match(Reader& in) {
    auto mark = in.mark<pegtl::rewind_mode::required>();
    in.skip_gap();
    const std::uint32_t begin = in.offset();
    if (!run<pegtl::seq<Rules...>>(in)) {
      in.record.expect(K, begin);
      return false;
    }
    in.record.token(K, {begin, in.offset()});
    return mark(true);
  }
};

/// The spelling of a keyword or sign right here.
template <Kind K>
struct spelled {
  using rule_t = spelled;
  using subs_t = pegtl::empty_list;

  static bool match(Reader& in) {
    constexpr std::string_view text = spelling(K);
    const std::string_view rest = in.text().substr(in.offset());
    if (!rest.starts_with(text)) return false;
    const char next = rest.size() > text.size() ? rest[text.size()] : '\0';
    if (is_keyword(K) ? is_word_char(next) : glued(next)) return false;
    in.bump_in_this_line(text.size());
    return true;
  }

 private:
  // `=` is not the beginning of `==`, nor are `.` and `..` of `..` and `...`.
  static constexpr bool glued(char next) {
    return (K == Kind::Assign && next == '=') || ((K == Kind::Dot || K == Kind::DotDot) && next == '.');
  }
};

template <Kind K>
struct word : token<K, spelled<K>> {};
template <Kind K>
struct sign : token<K, spelled<K>> {};

/// A node around what the rules write.
template <Kind K, typename... Rules>
struct node {
  using rule_t = node;
  using subs_t = pegtl::type_list<Rules...>;

  static bool match(Reader& in) {
    const std::uint32_t first = in.record.size();
    if (!run<pegtl::seq<Rules...>>(in)) return false;
    in.record.close(K, first);
    return true;
  }
};

/// A rule that looks at the text itself, after the gap before it.
template <typename Rule>
struct gap_before {
  using rule_t = gap_before;
  using subs_t = pegtl::type_list<Rule>;

  static bool match(Reader& in) {
    auto mark = in.mark<pegtl::rewind_mode::required>();
    in.skip_gap();
    return mark(run<Rule>(in));
  }
};

/// For messages: what is missing when the rule fails at its very beginning.
template <Kind K, typename Rule>
struct called {
  using rule_t = called;
  using subs_t = pegtl::type_list<Rule>;

  static bool match(Reader& in) {
    auto mark = in.mark<pegtl::rewind_mode::required>();
    in.skip_gap();
    const std::uint32_t begin = in.offset();
    const auto before = in.record.expected_at(begin);
    if (run<Rule>(in)) return mark(true);
    in.record.expect_instead(K, begin, before);
    return false;
  }
};

/// Over line ends, where the text cannot end: after a comma, an operator, an equals sign.
struct more {
  using rule_t = more;
  using subs_t = pegtl::empty_list;

  static bool match(Reader& in) {
    in.skip_lines_within_statement();
    return true;
  }
};

/// Over line ends if `then` or `else` comes behind them.
template <Kind K>
struct perhaps_on_next_line {
  using rule_t = perhaps_on_next_line;
  using subs_t = pegtl::empty_list;

  static bool match(Reader& in) {
    const std::uint32_t next = skip_lines(in.text(), in.offset());
    if (word_at(in.text(), next) == spelling(K)) in.go_to(next);
    return true;
  }
};

using comma = pegtl::seq<sign<Kind::Comma>, more>;

/// Brackets and what is in them; line ends are white space there.
template <Kind Open, Kind Close, typename... Rules>
struct bracketed {
  using rule_t = bracketed;
  using subs_t = pegtl::type_list<sign<Open>, Rules..., sign<Close>>;

  static bool match(Reader& in) {
    auto mark = in.mark<pegtl::rewind_mode::required>();
    if (!run<sign<Open>>(in)) return false;
    const std::uint32_t outer = in.record.bracket;
    in.record.bracket = in.offset() - 1;
    const bool matched = run<pegtl::seq<Rules..., sign<Close>>>(in);
    in.record.bracket = outer;
    return mark(matched);
  }
};

/// Only blanks between the beginning of the line and `at`: what stood before has ended, if only for a forgotten brace.
inline bool begins_line(std::string_view text, std::uint32_t at) {
  while (at > 0 && is_blank(text[at - 1])) --at;
  return at == 0 || text[at - 1] == '\n';
}

/// Nothing more on this line, or the brace that closes the block around.
template <char... Others>
struct at_end {
  using rule_t = at_end;
  using subs_t = pegtl::empty_list;

  static bool match(Reader& in) {
    const std::uint32_t at = skip_blanks(in.text(), in.offset());
    const char c = at < in.text().size() ? in.text()[at] : '\n';
    const bool ended = c == '\n' || c == '}' || ((c == Others) || ...) || begins_line(in.text(), at);
    if (!ended) in.record.expect(Kind::Newline, at);
    return ended;
  }
};

/// Gives up what cannot be understood, as one Error token.
inline void skip_as_error(Reader& in, std::uint32_t mistake, SkipTo to) {
  const Skip skip = skip_mistake(in.text(), in.offset(), mistake, to);
  if (skip.skipped.begin < skip.skipped.end) in.record.token(Kind::Error, skip.skipped);
  in.go_to(skip.resume);
}

/// How a statement goes on after a mistake: with the rest of its line given up, or up to a block that it still has.
struct to_line_end {
  static constexpr SkipTo skip = SkipTo::Line;
  static void match(Reader&) {}
};
struct to_comma {
  static constexpr SkipTo skip = SkipTo::Comma;
  static void match(Reader&) {}
};
template <typename BlockRule>
struct to_block {
  static constexpr SkipTo skip = SkipTo::Block;
  static void match(Reader& in) {
    (void)run<BlockRule>(in);
    skip_as_error(in, in.offset(), SkipTo::Line);  // what stands behind the block belongs to the same mistake
  }
};

/// A statement is recognised by its head. From there on it cannot fail: parts are kept up to the first mistake, which
/// is reported.
template <Kind K, typename Head, typename Recovery, typename... Parts>
struct statement {
  using rule_t = statement;
  using subs_t = pegtl::type_list<Head, pegtl::opt<Parts>...>;

  static bool match(Reader& in) {
    const std::uint32_t begin = in.offset();
    const std::uint32_t first = in.record.size();
    if (!run<Head>(in)) return false;
    if (!(run<Parts>(in) && ...)) {
      skip_as_error(in, in.record.report_failure(begin), Recovery::skip);
      Recovery::match(in);
    }
    in.record.close(K, first);
    return true;
  }
};

/// A statement of one line.
template <Kind K, typename Head, typename... Parts>
struct line : statement<K, Head, to_line_end, Parts..., at_end<>> {};

/// How far the line of a place is indented.
inline std::uint32_t indentation(std::string_view text, std::uint32_t at) {
  const std::size_t end = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t line = end == std::string_view::npos ? 0 : end + 1;
  return static_cast<std::uint32_t>(std::min(text.find_first_not_of(" \t", line), text.size()) - line);
}

/// Items up to a closing brace, or to the end of the text where `opened` is Record::nowhere. Mistakes between items end
/// at their line; a statement that only the blocks around can hold ends the block, as if its brace had been forgotten.
template <typename Item, char Separator>
class Items {
 public:
  Items(Reader& in, std::uint32_t opened) : in_(in), opened_(opened) {}

  void read() {
    while (true) {
      skip_separators();
      if (in_.empty()) {
        if (is_block()) report_unclosed({in_.record.end(), in_.record.end()});
        return;
      }
      if (is_block() && in_.sees('}')) return (void)run<sign<Kind::RightBrace>>(in_);
      const bool after_misplaced = in_.record.misplaced;
      if (run<Item>(in_)) {
        if (!is_block() && after_misplaced) in_.record.misplaced = false;
        continue;
      }
      const auto keyword = statement_at(in_.text(), in_.offset());
      if (keyword && ends_block(*keyword)) return report_unclosed(lexeme_at(in_.text(), in_.offset()));
      give_up_item(keyword.has_value());
    }
  }

 private:
  bool is_block() const { return opened_ != Record::nowhere; }

  void skip_separators() {
    in_.go_to(skip_lines(in_.text(), in_.offset()));
    while (Separator == ',' && in_.sees(',')) {
      (void)run<sign<Kind::Comma>>(in_);
      in_.go_to(skip_lines(in_.text(), in_.offset()));
    }
  }

  bool ends_block(Kind keyword) const {
    return is_block() && (in_.record.enclosing & statement_word(keyword)) != 0 &&
           indentation(in_.text(), in_.offset()) <= indentation(in_.text(), opened_);
  }

  void report_unclosed(Span at) {
    in_.record.report(
        {SyntaxError::What::Unclosed, at, {opened_, opened_ + 1}, {std::string(expectation(Kind::RightBrace))}});
  }

  void give_up_item(bool is_statement_of_another_block) {
    const std::uint32_t begin = in_.offset();
    const bool misplaced = is_statement_of_another_block || in_.sees('}');
    const auto errors_before = in_.record.mark();
    const std::uint32_t mistake = std::max(in_.record.report_failure(begin), begin);
    if (misplaced && in_.record.misplaced) in_.record.undo(errors_before);
    in_.record.misplaced = misplaced;
    if (in_.sees('}')) {
      in_.record.token(Kind::Error, {begin, begin + 1});
      in_.go_to(begin + 1);
      return;
    }
    skip_as_error(in_, mistake, Separator == ',' ? SkipTo::Comma : SkipTo::Line);
  }

  Reader& in_;
  std::uint32_t opened_;
};

/// Braces with items of one kind; `Words` are the statements they may hold.
template <Kind K, StatementWords Words, char Separator, typename Item>
struct items_in_braces {
  using rule_t = items_in_braces;
  using subs_t = pegtl::type_list<sign<Kind::LeftBrace>, pegtl::star<Item>>;

  static bool match(Reader& in) {
    const std::uint32_t first = in.record.size();
    if (!run<sign<Kind::LeftBrace>>(in)) return false;
    const StatementWords outer = in.record.enclosing;
    in.record.enclosing |= Words;
    Items<Item, Separator>(in, in.offset() - 1).read();
    in.record.enclosing = outer;
    in.record.close(K, first);
    return true;
  }
};

template <StatementWords Words, typename Item>
struct block : items_in_braces<Kind::Block, Words, '\n', Item> {};

}  // namespace toile::syntax
