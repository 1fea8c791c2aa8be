#include "grammar/format/format.hpp"

#include <utility>

#include "grammar/format/columns.hpp"
#include "grammar/format/layout.hpp"

namespace toile::syntax {
namespace {

/// The text of a token that counts; of comments without the blanks at their ends.
std::string_view significant(const Node& node, const Source& source) {
  const std::string_view text = source.slice(node.span);
  return is_trivia(node.kind) ? text.substr(0, text.find_last_not_of(" \t\r") + 1) : text;
}

/// The next node that is neither a blank nor the end of a line.
NodeId next_significant(const Tree& tree, NodeId id) {
  do {
    ++id;
  } while (id < tree.size() && (tree[id].kind == Kind::Space || tree[id].kind == Kind::Newline));
  return id;
}

}  // namespace

std::string format(const Parsed& parsed, const Source& source) {
  Source laid_out(source.name(), set_in_columns(print(lay_out(parsed.tree, source))));
  const Parsed reread = parse(laid_out);
  const bool is_same = reread.errors.empty() && same_script(parsed, source, reread, laid_out);
  return std::string(is_same ? laid_out.text() : source.text());
}

bool same_script(const Parsed& a, const Source& a_source, const Parsed& b, const Source& b_source) {
  NodeId i = Tree::root(), j = Tree::root();
  while (true) {
    i = next_significant(a.tree, i);
    j = next_significant(b.tree, j);
    if (i == a.tree.size() || j == b.tree.size()) return i == a.tree.size() && j == b.tree.size();
    const Node &first = a.tree[i], &second = b.tree[j];
    if (first.kind != second.kind) return false;
    if (is_token(first.kind) && significant(first, a_source) != significant(second, b_source)) return false;
  }
}

}  // namespace toile::syntax
