// The grammar of expressions; docs/grammar.md is its plain text.
#pragma once

#include <optional>

#include "grammar/combinators.hpp"

namespace toile::syntax::rules {

// ------------------------------------------------------------------------------------------------------- words

using word_char = pegtl::identifier_other;

struct any_name : token<Kind::Name, pegtl::identifier> {};

/// The name of a value; everywhere else keywords are as good as any word.
struct unreserved {
  using rule_t = unreserved;
  using subs_t = pegtl::empty_list;
  static bool match(Reader& in) { return !is_reserved(word_at(in.text(), in.offset())); }
};
struct value_name : token<Kind::Name, unreserved, pegtl::identifier> {};

// ------------------------------------------------------------------------------------------------------ leaves

struct unit_word {
  using rule_t = unit_word;
  using subs_t = pegtl::empty_list;
  static bool match(Reader& in) {
    const std::string_view found = word_at(in.text(), in.offset());
    if (!is_unit(found)) return false;
    in.bump_in_this_line(found.size());
    return true;
  }
};
struct unit_power : pegtl::seq<pegtl::one<'^'>, pegtl::opt<pegtl::one<'-'>>, pegtl::plus<pegtl::digit>,
                               pegtl::not_at<pegtl::sor<word_char, pegtl::seq<pegtl::one<'.'>, pegtl::digit>>>> {};
struct unit_factor : pegtl::seq<unit_word, pegtl::opt<unit_power>> {};
struct unit_text
    : pegtl::sor<pegtl::one<'%'>, pegtl::seq<unit_factor, pegtl::star<pegtl::one<'*', '/'>, unit_factor>>> {};

/// A unit stands right behind its number or blanks away, never on the next line. That it may stand there is no news.
struct unit {
  using rule_t = unit;
  using subs_t = pegtl::type_list<unit_text>;
  static bool match(Reader& in) {
    auto mark = in.mark<pegtl::rewind_mode::required>();
    while (in.sees(' ') || in.sees('\t')) in.bump_in_this_line();
    const std::uint32_t begin = in.offset();
    if (!run<unit_text>(in)) return false;
    in.record.token(Kind::Unit, {begin, in.offset()});
    return mark(true);
  }
};

struct digits : pegtl::plus<pegtl::digit> {};
struct decimals : pegtl::seq<pegtl::one<'.'>, digits> {};
struct exponent : pegtl::seq<pegtl::one<'e', 'E'>, pegtl::opt<pegtl::one<'+', '-'>>, digits> {};
struct number_text : pegtl::seq<digits, pegtl::opt<decimals>, pegtl::opt<exponent>,
                                pegtl::sor<pegtl::not_at<word_char>, pegtl::at<unit_text>>> {};
struct number : node<Kind::Number, token<Kind::Digits, number_text>, pegtl::opt<unit>> {};

struct escape : pegtl::seq<pegtl::one<'\\'>, pegtl::one<'"', '\\', 'n', '{'>> {};
struct characters : pegtl::star<pegtl::sor<pegtl::not_one<'"', '\\', '\n', '{'>, escape>> {};
struct text : token<Kind::Text, pegtl::one<'"'>, characters, pegtl::one<'"'>> {};

template <unsigned N>
struct hex : pegtl::seq<pegtl::rep<N, pegtl::xdigit>, pegtl::not_at<word_char>> {};
struct colour : node<Kind::Colour, token<Kind::Hex, pegtl::one<'#'>, pegtl::sor<hex<6>, hex<3>, hex<8>>>> {};

struct boolean : node<Kind::Boolean, pegtl::sor<word<Kind::KwTrue>, word<Kind::KwFalse>>> {};
struct name_ref : node<Kind::NameRef, value_name> {};

// ----------------------------------------------------------------------------------------------------- nesting

/// Counts one more level of expressions while it lives, and how deep the tree below it has become.
class Nesting {
 public:
  explicit Nesting(Record& record) : record_(record), outer_height_(record.depth == 0 ? 0 : record.height) {
    ++record_.depth;
    record_.height = 0;
  }
  ~Nesting() {
    --record_.depth;
    record_.height = std::max(outer_height_, record_.height + 1);
  }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;

 private:
  Record& record_;
  int outer_height_;
};

/// Puts a node around all since `first`, which makes the tree one deeper.
inline bool wrap(Reader& in, Kind kind, std::uint32_t first) {
  in.record.close(kind, first);
  return in.record.allows(++in.record.height, in.record.end());
}

// ------------------------------------------------------------------------------------------------- expressions

struct expression;
struct operators;

struct tuple_items : pegtl::seq<expression, pegtl::opt<comma, expression, pegtl::opt<comma, expression>>> {};
struct tuple : node<Kind::Tuple, bracketed<Kind::LeftParen, Kind::RightParen, tuple_items>> {};

struct generated : pegtl::seq<any_name, word<Kind::KwIn>, expression, pegtl::opt<sign<Kind::DotDot>, expression>,
                              pegtl::opt<word<Kind::KwIf>, expression>> {};
struct generator : node<Kind::For, word<Kind::KwFor>, generated> {};
struct list_items
    : pegtl::opt<expression, pegtl::sor<generator, pegtl::seq<pegtl::star<comma, expression>, pegtl::opt<comma>>>> {};
struct list : node<Kind::List, bracketed<Kind::LeftBracket, Kind::RightBracket, list_items>> {};

/// `{w}` and `{w in mm}` in a text, whose tokens go from one brace or quote to the next.
struct text_begin : token<Kind::Text, pegtl::one<'"'>, characters, pegtl::one<'{'>> {};
struct inserted : node<Kind::Inserted, expression, pegtl::opt<word<Kind::KwIn>, token<Kind::Unit, unit_text>>> {};
struct closed_insertion {
  using rule_t = closed_insertion;
  using subs_t = pegtl::empty_list;
  static bool match(Reader& in) {
    if (!in.sees('}')) return false;
    in.bump_in_this_line();
    (void)run<characters>(in);
    if (!in.sees('"') && !in.sees('{')) {
      in.record.expect(Kind::Text, in.offset());
      return false;
    }
    in.bump_in_this_line();
    return true;
  }
};
struct text_end : called<Kind::RightBrace, token<Kind::Text, closed_insertion>> {};
/// A piece that ends with a brace has another value behind it.
struct more_inserted {
  using rule_t = more_inserted;
  using subs_t = pegtl::empty_list;
  static bool match(Reader& in) { return in.offset() > 0 && in.text()[in.offset() - 1] == '{'; }
};
struct string
    : node<Kind::String,
           pegtl::sor<text, pegtl::seq<text_begin, inserted, text_end, pegtl::star<more_inserted, inserted, text_end>,
                                       pegtl::not_at<more_inserted>>>> {};

/// Behind the bracket a name and a colon.
struct named_next {
  using rule_t = named_next;
  using subs_t = pegtl::empty_list;
  static bool match(Reader& in) {
    if (!in.sees('(')) return false;
    const std::uint32_t name = skip_lines(in.text(), in.offset() + 1);
    if (name == in.text().size() || !is_letter(in.text()[name])) return false;
    const auto length = static_cast<std::uint32_t>(word_at(in.text(), name).size());
    const std::uint32_t colon = skip_blanks(in.text(), name + length);
    return colon < in.text().size() && in.text()[colon] == ':';
  }
};
struct record_field : node<Kind::Argument, any_name, sign<Kind::Colon>, more, expression> {};
struct record_part : pegtl::sor<record_field, node<Kind::Argument, expression, sign<Kind::Ellipsis>>> {};
struct record
    : pegtl::seq<named_next, node<Kind::RecordLiteral, bracketed<Kind::LeftParen, Kind::RightParen, record_field,
                                                                 pegtl::star<comma, record_part>, pegtl::opt<comma>>>> {
};

struct primary
    : called<Kind::NameRef, pegtl::sor<name_ref, number, gap_before<record>, tuple, string, list, colour, boolean>> {};

struct argument : node<Kind::Argument, pegtl::sor<pegtl::seq<any_name, sign<Kind::Colon>, more, expression>,
                                                  pegtl::seq<expression, pegtl::opt<sign<Kind::Ellipsis>>>>> {};
struct arguments : bracketed<Kind::LeftParen, Kind::RightParen,
                             pegtl::opt<argument, pegtl::star<comma, argument>, pegtl::opt<comma>>> {};
struct index : bracketed<Kind::LeftBracket, Kind::RightBracket, expression> {};
struct member : pegtl::seq<sign<Kind::Dot>, any_name> {};
struct tail : pegtl::sor<member, arguments, index> {};

/// A primary and what is called, picked and indexed of it, to any length. Which of them comes shows in one character.
struct postfix {
  using rule_t = postfix;
  using subs_t = pegtl::type_list<primary, pegtl::star<tail>>;

  static bool match(Reader& in) {
    auto mark = in.mark<pegtl::rewind_mode::required>();
    const std::uint32_t first = in.record.size();
    if (!run<primary>(in)) return false;
    while (const auto kind = next(in)) {
      if (!wrap(in, *kind, first)) return false;
    }
    return mark(true);
  }

 private:
  static std::optional<Kind> next(Reader& in) {
    const std::uint32_t at = skip_blanks(in.text(), in.offset());
    const char c = at < in.text().size() ? in.text()[at] : '\0';
    if (c == '.' && run<member>(in)) return Kind::Member;
    if (c == '(' && run<arguments>(in)) return Kind::Call;
    if (c == '[' && run<index>(in)) return Kind::Index;
    return std::nullopt;
  }
};

// How tightly operators bind. A prefix operator takes what binds as tightly as itself or tighter.
inline constexpr int or_power = 1;
inline constexpr int and_power = 2;
inline constexpr int not_power = 3;
inline constexpr int comparison_power = 4;
inline constexpr int sum_power = 5;
inline constexpr int product_power = 6;
inline constexpr int minus_power = 7;
inline constexpr int exponent_power = 8;

struct Operator {
  Kind kind;
  int power;
};

inline std::optional<Operator> operator_at(std::string_view text, std::uint32_t at) {
  if (at >= text.size()) return std::nullopt;
  const bool equals = text.substr(at + 1, 1) == "=";
  switch (text[at]) {
    case '+':
      return Operator{Kind::Plus, sum_power};
    case '-':
      return Operator{Kind::Minus, sum_power};
    case '*':
      return Operator{Kind::Star, product_power};
    case '/':
      return Operator{Kind::Slash, product_power};
    case '^':
      return Operator{Kind::Caret, exponent_power};
    case '<':
      return Operator{equals ? Kind::LessEqual : Kind::Less, comparison_power};
    case '>':
      return Operator{equals ? Kind::GreaterEqual : Kind::Greater, comparison_power};
    case '=':
      return equals ? std::optional(Operator{Kind::Equal, comparison_power}) : std::nullopt;
    case '!':
      return equals ? std::optional(Operator{Kind::NotEqual, comparison_power}) : std::nullopt;
    case 'a':
      return word_at(text, at) == "and" ? std::optional(Operator{Kind::KwAnd, and_power}) : std::nullopt;
    case 'o':
      return word_at(text, at) == "or" ? std::optional(Operator{Kind::KwOr, or_power}) : std::nullopt;
    default:
      return std::nullopt;
  }
}

/// Behind a `+`: `back.side` or `panel[2].edge`, which goes on with a chain.
inline bool edge_follows(std::string_view text, std::uint32_t plus) {
  std::uint32_t at = skip_lines(text, plus + 1);
  if (at >= text.size() || !is_letter(text[at])) return false;
  at += static_cast<std::uint32_t>(word_at(text, at).size());
  if (at < text.size() && text[at] == '[') {
    const std::size_t close = text.find_first_of("]\n", at);
    if (close == std::string_view::npos || text[close] != ']') return false;
    at = static_cast<std::uint32_t>(close) + 1;
  }
  return at + 1 < text.size() && text[at] == '.' && is_letter(text[at + 1]);
}

/// Prefix and infix operators by precedence climbing, from `Lowest` on. In a chain of edges a `+` before an edge is the
/// chain's.
class Climb {
 public:
  explicit Climb(Reader& in, bool in_chain = false) : in_(in), in_chain_(in_chain) {}

  bool read(int lowest) {
    const Nesting nesting(in_.record);
    if (!in_.record.allows(in_.record.depth, skip_blanks(in_.text(), in_.offset()))) return false;
    auto mark = in_.mark<pegtl::rewind_mode::required>();
    in_.skip_gap();
    const std::uint32_t first = in_.record.size();
    int highest = exponent_power;  // what may still come to the right of what was read
    if (!read_operand(lowest, first, highest)) return false;
    while (const auto op = next_operator(lowest, highest)) {
      run_more(*op);
      if (!read(right_power(*op)) || !wrap(in_, Kind::Binary, first)) return false;
      highest = op->power == comparison_power ? comparison_power - 1 : op->power;
    }
    return mark(true);
  }

 private:
  bool read_operand(int lowest, std::uint32_t first, int& highest) {
    if (in_.sees('-')) return read_prefix<Kind::Minus>(minus_power, first, highest);
    if (lowest <= not_power && word_at(in_.text(), in_.offset()) == "not") {
      return read_prefix<Kind::KwNot>(not_power, first, highest);
    }
    return run<postfix>(in_);
  }

  template <Kind K>
  bool read_prefix(int power, std::uint32_t first, int& highest) {
    highest = power - 1;
    return run<token<K, spelled<K>>>(in_) && read(power) && wrap(in_, Kind::Unary, first);
  }

  std::optional<Operator> next_operator(int lowest, int highest) {
    const std::uint32_t before = in_.offset();
    in_.skip_gap();
    auto op = operator_at(in_.text(), in_.offset());
    if (in_chain_ && op && op->kind == Kind::Plus && edge_follows(in_.text(), in_.offset())) op.reset();
    if (op && op->power >= lowest && op->power <= highest) return op;
    if (!op) in_.record.expect(Kind::Binary, in_.offset());
    in_.go_to(before);
    return std::nullopt;
  }

  void run_more(Operator op) {
    const std::uint32_t begin = in_.offset();
    in_.bump_in_this_line(spelling(op.kind).size());
    in_.record.token(op.kind, {begin, in_.offset()});
    (void)run<more>(in_);
  }

  // `^` takes another power or a minus to its right, all others what binds more tightly than themselves.
  static int right_power(Operator op) { return op.power == exponent_power ? minus_power : op.power + 1; }

  Reader& in_;
  bool in_chain_;
};

/// What Climb reads, for the analysis of the grammar: a chain of operands, each in its own turn a Climb.
struct prefixes : pegtl::star<pegtl::sor<sign<Kind::Minus>, word<Kind::KwNot>>> {};
struct infix : pegtl::seq<sign<Kind::Plus>, operators> {};
struct operators {
  using rule_t = operators;
  using subs_t = pegtl::type_list<prefixes, postfix, pegtl::star<infix>>;
  static bool match(Reader& in) { return Climb(in).read(or_power); }
};

/// Where a part of an edge ends.
struct end_of_part {
  using rule_t = end_of_part;
  using subs_t = pegtl::type_list<operators>;
  static bool match(Reader& in) { return Climb(in, true).read(or_power); }
};

struct choice : node<Kind::If, word<Kind::KwIf>, expression, perhaps_on_next_line<Kind::KwThen>, word<Kind::KwThen>,
                     more, expression, perhaps_on_next_line<Kind::KwElse>, word<Kind::KwElse>, more, expression> {};

struct expression {
  using rule_t = expression;
  using subs_t = pegtl::type_list<pegtl::sor<choice, operators>>;
  static bool match(Reader& in) {
    const Nesting nesting(in.record);
    auto mark = in.mark<pegtl::rewind_mode::required>();
    in.skip_gap();
    if (!in.record.allows(in.record.depth, in.offset())) return false;
    return mark(word_at(in.text(), in.offset()) == "if" ? run<choice>(in) : run<operators>(in));
  }
};

}  // namespace toile::syntax::rules
