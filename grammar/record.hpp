// What the grammar writes down while it matches: a flat list of events, and how far it got before it failed.
#pragma once

#include <bitset>
#include <vector>

#include "grammar/kinds.hpp"
#include "grammar/parse.hpp"
#include "grammar/source.hpp"
#include "grammar/words.hpp"

namespace toile::syntax {

/// A token, or the end of a node that holds all events from `first` on. Children come before their parents, so a node
/// can be put around what was already read, as a sum around its first term; undoing is cutting off the end.
struct Event {
  Kind kind;
  Span span;
  std::uint32_t first;
};

class Record {
 public:
  static constexpr std::uint32_t nowhere = 0xffffffffu;
  /// How deep expressions may nest, and how long a chain of operators may be: both become the depth of the tree.
  static constexpr int max_depth = 256;

  explicit Record(std::string_view text) : text_(text) { events_.reserve(text.size() / 4); }

  // Events.
  std::uint32_t size() const { return static_cast<std::uint32_t>(events_.size()); }
  void token(Kind kind, Span span) { events_.push_back({kind, span, size()}); }
  /// A node around all since `first`; a node without any token is no node.
  void close(Kind kind, std::uint32_t first);
  /// The end of the last token.
  std::uint32_t end() const { return events_.empty() ? 0 : events_.back().span.end; }

  /// Where the list stood before a rule that may fail.
  struct Mark {
    std::size_t events;
    std::size_t errors;
  };
  Mark mark() const { return {events_.size(), errors_.size()}; }
  void undo(Mark mark) {
    events_.resize(mark.events);
    errors_.resize(mark.errors);
  }

  // Failures. Only the furthest counts: what came before it was understood in some way.
  using Expected = std::bitset<kind_count>;
  void expect(Kind kind, std::uint32_t at);
  /// For a construct with a name of its own: forget what its parts would have liked to see at `at`, say `kind` instead.
  Expected expected_at(std::uint32_t at) const { return furthest_.at == at ? furthest_.expected : Expected{}; }
  void expect_instead(Kind kind, std::uint32_t at, const Expected& before);

  /// Turns the furthest failure into an error, for a statement or item that begins at `begin`; gives its place.
  std::uint32_t report_failure(std::uint32_t begin);
  void report(SyntaxError error);

  const std::vector<Event>& events() const { return events_; }
  std::vector<SyntaxError>& errors() { return errors_; }

  // What surrounds the place being read; rules restore these when they end.
  std::uint32_t bracket = nowhere;  // the innermost open bracket of the expression
  StatementWords enclosing = 0;     // statements that the blocks around could hold
  int depth = 0;                    // of expressions in expressions
  int height = 0;                   // of the expression read last
  bool misplaced = false;           // the last item stood in the wrong block: those after it are not news

  /// Checks a depth; beyond the limit remembers the place and gives false.
  bool allows(int depth_or_height, std::uint32_t at);

 private:
  struct Furthest {
    std::uint32_t at = 0;
    std::uint32_t before = 0;  // the end of the token before
    std::uint32_t bracket = nowhere;
    Expected expected;
  };
  SyntaxError failure(std::uint32_t begin) const;

  std::string_view text_;
  std::vector<Event> events_;
  std::vector<SyntaxError> errors_;
  Furthest furthest_;
  std::uint32_t too_deep_ = nowhere;
};

}  // namespace toile::syntax
