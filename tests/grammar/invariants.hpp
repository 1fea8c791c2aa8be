// What holds of every tree, whatever the text: checked by the tests on mutilated scripts and by the fuzzer.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "grammar/parse.hpp"

namespace toile::syntax {

/// The first thing wrong with a tree as a lossless tree of that text, or nothing.
inline std::string broken_invariant(const Parsed& parsed, const Source& source) {
  const Tree& tree = parsed.tree;
  const auto size = static_cast<std::uint32_t>(source.text().size());
  if (tree.size() == 0 || tree[0].kind != Kind::File || tree[0].span != Span{0, size}) return "no file at the root";

  std::uint32_t covered = 0;
  bool error_token = false;
  std::vector<NodeId> last_child(tree.size(), no_node);
  std::vector<int> depth(tree.size(), 0);
  for (NodeId id = 1; id < tree.size(); ++id) {
    const Node& node = tree[id];
    const auto broken = [&](const char* what) { return fmt::format("node {} ({}): {}", id, name(node.kind), what); };
    if (node.parent >= id) return broken("stands before its parent");
    const Node& parent = tree[node.parent];
    if (is_token(parent.kind)) return broken("is a child of a token");
    if (node.span.begin < parent.span.begin || node.span.end > parent.span.end)
      return broken("reaches out of its parent");
    NodeId& sibling = last_child[node.parent];
    if ((sibling == no_node ? parent.first_child : tree[sibling].next_sibling) != id) return broken("is not linked");
    sibling = id;
    depth[id] = depth[node.parent] + 1;
    if (depth[id] > 1500) return broken("is too deep to walk by recursion");
    if (is_token(node.kind) != (node.first_child == no_node)) return broken("is a node without tokens");
    if (!is_token(node.kind)) continue;
    if (node.span.begin != covered || node.span.end <= covered) return broken("does not join the token before");
    covered = node.span.end;
    error_token = error_token || node.kind == Kind::Error;
  }
  if (covered != size) return "the text goes on after the last token";
  if (error_token && parsed.errors.empty()) return "text was given up in silence";

  std::uint32_t before = 0;
  for (const SyntaxError& error : parsed.errors) {
    if (error.span.begin > error.span.end || error.span.end > size || error.opened.end > size)
      return "an error off the text";
    if (error.span.begin < before) return "errors out of order";
    before = error.span.begin;
  }
  return {};
}

}  // namespace toile::syntax
