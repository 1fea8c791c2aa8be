#include "grammar/view.hpp"

#include <algorithm>
#include <string_view>

namespace toile::syntax {

std::optional<Token> token(View parent, Kind kind) {
  for (const View view : children(parent)) {
    if (view.kind() == kind) return as<Token>(view);
  }
  return std::nullopt;
}

bool has(View parent, Kind kind) {
  return token(parent, kind).has_value();
}

std::string doc(View statement, const Source& source) {
  // Nodes are numbered in the order of the text, so the leaves right before a node have the ids right before its own.
  std::vector<std::string_view> lines;
  int newlines = 0;
  for (NodeId id = statement.id; id-- > 0;) {
    const Node& leaf = (*statement.tree)[id];
    if (!is_trivia(leaf.kind) || leaf.parent != statement.node().parent) break;
    if (leaf.kind == Kind::Comment) break;
    if (leaf.kind == Kind::Newline && ++newlines > 1) break;
    if (leaf.kind != Kind::DocComment) continue;
    newlines = 0;
    std::string_view text = source.slice(leaf.span).substr(3);
    if (text.starts_with(' ')) text.remove_prefix(1);
    lines.push_back(text);
  }
  std::string joined;
  std::for_each(lines.rbegin(), lines.rend(), [&](std::string_view line) {
    if (!joined.empty()) joined += '\n';
    joined += line;
  });
  return joined;
}

}  // namespace toile::syntax
