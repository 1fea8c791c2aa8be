#include "grammar/format/margins.hpp"

#include <utility>

namespace toile::syntax {
namespace {

std::string_view without_trailing_blanks(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

}  // namespace

Margins::Margins(const Tree& tree, const Source& source) {
  NodeId before = no_node;  // the last token
  int newlines = 0;         // since it, or since the last comment
  bool any = false;
  Margin next;
  const auto settle = [&](NodeId token) {
    next.blank_before = newlines > 1 && any;
    if (next.blank_before || !next.above.empty()) margins_[token] = std::exchange(next, {});
    newlines = 0;
    any = true;
  };
  for (NodeId id = 0; id < tree.size(); ++id) {
    const Node& node = tree[id];
    if (!is_token(node.kind) || node.kind == Kind::Space) continue;
    if (node.kind == Kind::Newline) {
      ++newlines;
    } else if (is_trivia(node.kind)) {
      const std::string_view text = without_trailing_blanks(source.slice(node.span));
      if (newlines == 0 && before != no_node) {
        margins_[before].beside = text;
      } else {
        next.above.push_back({text, newlines > 1 && any});
        newlines = 0;
        any = true;
      }
    } else {
      settle(id);
      before = id;
    }
  }
  settle(no_node);
}

const Margin& Margins::of(NodeId token) const {
  static const Margin none;
  const auto found = margins_.find(token);
  return found == margins_.end() ? none : found->second;
}

NodeId first_token(const Tree& tree, NodeId node) {
  while (tree[node].first_child != no_node) {
    node = tree[node].first_child;
    while (is_trivia(tree[node].kind)) node = tree[node].next_sibling;
  }
  return node;
}

NodeId last_token(const Tree& tree, NodeId node) {
  while (tree[node].first_child != no_node) {
    NodeId last = no_node;
    for (NodeId child = tree[node].first_child; child != no_node; child = tree[child].next_sibling) {
      if (!is_trivia(tree[child].kind)) last = child;
    }
    node = last;
  }
  return node;
}

}  // namespace toile::syntax
