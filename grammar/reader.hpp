// The input of the PEGTL rules: a text, and the record that goes back whenever the text does.
#pragma once

#include <tao/pegtl.hpp>

#include "grammar/record.hpp"
#include "grammar/scan.hpp"

namespace toile::syntax {

namespace pegtl = tao::pegtl;

class Reader;

/// PEGTL marks the input where it may have to come back; ours takes the record along. Other rewind modes mean that a
/// rule further out does it.
template <pegtl::rewind_mode M>
class ReaderMark {
 public:
  static constexpr pegtl::rewind_mode next_rewind_mode = M;
  explicit ReaderMark(Reader&) {}
  bool operator()(bool result) const { return result; }
};

template <>
class ReaderMark<pegtl::rewind_mode::required> {
 public:
  static constexpr pegtl::rewind_mode next_rewind_mode = pegtl::rewind_mode::active;
  explicit inline ReaderMark(Reader& in);
  inline ~ReaderMark();
  ReaderMark(const ReaderMark&) = delete;
  ReaderMark& operator=(const ReaderMark&) = delete;

  bool operator()(bool result) {
    kept_ = result;
    return result;
  }

 private:
  Reader& in_;
  const char* at_;
  Record::Mark record_;
  bool kept_ = false;
};

class Reader : public pegtl::memory_input<pegtl::tracking_mode::lazy, pegtl::eol::lf, const char*> {
 public:
  explicit Reader(std::string_view text)
      : memory_input(text.data(), text.data() + text.size(), ""), record(text), text_(text) {}

  template <pegtl::rewind_mode M>
  ReaderMark<M> mark() {
    return ReaderMark<M>(*this);
  }

  std::string_view text() const { return text_; }
  std::uint32_t offset() const { return static_cast<std::uint32_t>(current() - text_.data()); }
  void go_to(std::uint32_t offset) { iterator() = text_.data() + offset; }
  bool sees(char c) const { return !empty() && peek_char() == c; }

  /// To the next token: within a line, or inside brackets over line ends too, unless a statement seems to begin there.
  void skip_gap() {
    if (record.bracket == Record::nowhere) {
      go_to(skip_blanks(text_, offset()));
    } else {
      skip_lines_within_statement();
    }
  }
  void skip_lines_within_statement() {
    const std::uint32_t line_end = skip_blanks(text_, offset());
    const std::uint32_t next = skip_lines(text_, line_end);
    go_to(next == line_end || !statement_at(text_, next) ? next : line_end);
  }

  Record record;

 private:
  std::string_view text_;
};

ReaderMark<pegtl::rewind_mode::required>::ReaderMark(Reader& in)
    : in_(in), at_(in.current()), record_(in.record.mark()) {}

ReaderMark<pegtl::rewind_mode::required>::~ReaderMark() {
  if (kept_) return;
  in_.iterator() = at_;
  in_.record.undo(record_);
}

/// Matches a rule where the input stands; where it fails nothing has happened.
template <typename Rule>
bool run(Reader& in) {
  return pegtl::normal<Rule>::template match<pegtl::apply_mode::nothing, pegtl::rewind_mode::required, pegtl::nothing,
                                             pegtl::normal>(in);
}

}  // namespace toile::syntax
