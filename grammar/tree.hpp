// The lossless syntax tree: a flat array of nodes over the text. Every byte of the source lies in exactly one token,
// and white space, comments and text that could not be understood (kind Error) are tokens too.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "grammar/kinds.hpp"
#include "grammar/source.hpp"

namespace toile::syntax {

using NodeId = std::uint32_t;
inline constexpr NodeId no_node = 0xffffffffu;

struct Node {
  Kind kind = Kind::Error;
  Span span;
  NodeId parent = no_node;
  NodeId first_child = no_node;
  NodeId next_sibling = no_node;
};

/// Immutable; node 0 is the file. Children stand in the order of the text.
class Tree {
 public:
  explicit Tree(std::vector<Node> nodes) : nodes_(std::move(nodes)) {}

  const Node& operator[](NodeId id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }
  static constexpr NodeId root() { return 0; }

 private:
  std::vector<Node> nodes_;
};

}  // namespace toile::syntax
