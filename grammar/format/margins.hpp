// What stands around the tokens: comments and empty lines, each given to the token that it belongs to.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "grammar/tree.hpp"

namespace toile::syntax {

/// A comment in lines of its own.
struct Remark {
  std::string_view text;      // without blanks at its end
  bool blank_before = false;  // an empty line, or several, before it
};

struct Margin {
  std::vector<Remark> above;  // since the token before
  bool blank_before = false;  // between what is above and the token
  std::string_view beside;    // the comment that ends the token's line
};

class Margins {
 public:
  Margins(const Tree& tree, const Source& source);

  /// Of a token; of the end of the text for no_node.
  const Margin& of(NodeId token) const;

 private:
  std::unordered_map<NodeId, Margin> margins_;  // of the few tokens that have one
};

/// The first and the last token of a node, or the node itself.
NodeId first_token(const Tree& tree, NodeId node);
NodeId last_token(const Tree& tree, NodeId node);

}  // namespace toile::syntax
