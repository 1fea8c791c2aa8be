// Walking the tree: the base of the typed views in ast.hpp.
#pragma once

#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "grammar/tree.hpp"

namespace toile::syntax {

/// A place in a tree. Two words, copied freely; lives as long as the tree.
struct View {
  const Tree* tree = nullptr;
  NodeId id = no_node;

  const Node& node() const { return (*tree)[id]; }
  Kind kind() const { return node().kind; }
  /// From the first to the last token of the construct, without the white space and comments around it.
  Span span() const { return node().span; }

  friend bool operator==(View a, View b) { return a.tree == b.tree && a.id == b.id; }
};

/// A leaf; its text is `source.slice(token.span())`.
struct Token : View {
  static constexpr bool matches(Kind kind) { return is_token(kind); }
};

/// The children of a node that are not trivia, in the order of the text.
class Children {
 public:
  class Iterator {
   public:
    using value_type = View;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::input_iterator_tag;

    Iterator() = default;
    Iterator(const Tree* tree, NodeId id) : at_{tree, id} { skip_trivia(); }
    View operator*() const { return at_; }
    Iterator& operator++() {
      at_.id = at_.node().next_sibling;
      skip_trivia();
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_.id == b.at_.id; }

   private:
    void skip_trivia() {
      while (at_.id != no_node && is_trivia(at_.kind())) at_.id = at_.node().next_sibling;
    }
    View at_;
  };

  explicit Children(View parent) : parent_(parent) {}
  Iterator begin() const { return {parent_.tree, parent_.node().first_child}; }
  Iterator end() const { return {parent_.tree, no_node}; }

 private:
  View parent_;
};

inline Children children(View view) {
  return Children(view);
}

/// The view as a T if its node is one: `if (auto let = as<Let>(statement))`.
template <typename T>
std::optional<T> as(View view) {
  if (!T::matches(view.kind())) return std::nullopt;
  T result;
  result.tree = view.tree;
  result.id = view.id;
  return result;
}

/// The n-th child (from 0) that is a T.
template <typename T>
std::optional<T> child(View parent, int n = 0) {
  for (const View view : children(parent)) {
    if (T::matches(view.kind()) && n-- == 0) return as<T>(view);
  }
  return std::nullopt;
}

/// All children that are a T.
template <typename T>
std::vector<T> all(View parent) {
  std::vector<T> found;
  for (const View view : children(parent)) {
    if (auto match = as<T>(view)) found.push_back(*match);
  }
  return found;
}

/// The child T that stands directly after a keyword or sign, as the angle after `leaving`.
template <typename T>
std::optional<T> after(View parent, Kind mark) {
  bool marked = false;
  for (const View view : children(parent)) {
    if (marked) return as<T>(view);
    marked = view.kind() == mark;
  }
  return std::nullopt;
}

/// The first child token of that very kind.
std::optional<Token> token(View parent, Kind kind);

/// Whether a keyword or sign is present.
bool has(View parent, Kind kind);

/// The text of the `///` lines directly above a statement, joined by line breaks; empty without.
std::string doc(View statement, const Source& source);

}  // namespace toile::syntax
