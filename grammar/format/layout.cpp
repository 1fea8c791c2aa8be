#include "grammar/format/layout.hpp"

#include <tuple>
#include <utility>

#include "grammar/ast.hpp"
#include "grammar/format/margins.hpp"
#include "grammar/format/spacing.hpp"

namespace toile::syntax {
namespace {

constexpr int block_indent = 2;
constexpr int hanging_indent = 4;  // of what goes on over the end of a line

using Parts = std::vector<Doc>;

class Layout {
 public:
  Layout(const Tree& tree, const Source& source) : tree_(tree), source_(source), margins_(tree, source) {}

  Doc file() {
    Parts parts;
    for (const View view : children({&tree_, Tree::root()})) parts.push_back(item(view));
    append_above(parts, no_node);
    return concat(std::move(parts));
  }

 private:
  // ------------------------------------------------------------------------------------------------- tokens

  /// A token with its comments; those above the first token of a statement, and those at its end, the statement has.
  Doc token_doc(NodeId id) {
    const Margin& margin = margins_.of(id);
    Doc word = text(source_.slice(tree_[id].span));
    const bool above = id != first_ && !margin.above.empty();
    const bool beside = id != last_ && !margin.beside.empty();
    if (!above && !beside) return word;
    Parts parts;
    if (above) append_comments(parts, margin);
    if (above) parts.push_back(new_line());
    parts.push_back(std::move(word));
    if (beside) parts.push_back(comment(margin.beside));
    return concat(std::move(parts));
  }

  static void append_comments(Parts& parts, const Margin& margin) {
    for (const Remark& remark : margin.above) {
      parts.push_back(new_line());
      parts.push_back(comment(remark.text));
    }
  }

  /// The comments above a statement or the end of a block, each in its line, and the empty lines between them.
  void append_above(Parts& parts, NodeId token, bool begins_block = false) {
    const Margin& margin = margins_.of(token);
    for (const Remark& remark : margin.above) {
      parts.push_back(new_line());
      if (remark.blank_before && !begins_block) parts.push_back(blank_line());
      parts.push_back(comment(remark.text));
      begins_block = false;
    }
    const bool ends_block = token == no_node || tree_[token].kind == Kind::RightBrace;
    if (ends_block) return;
    parts.push_back(new_line());
    if (margin.blank_before && !begins_block) parts.push_back(blank_line());
  }

  bool commented_between(View left, View right) const {
    return !margins_.of(last_token(tree_, left.id)).beside.empty() ||
           !margins_.of(first_token(tree_, right.id)).above.empty();
  }

  // --------------------------------------------------------------------------------------------- statements

  /// A statement, a property or a parameter: what can stand in a line of its own, with the comments around it.
  Doc item(View view, bool begins_block = false) {
    const NodeId first = first_token(tree_, view.id), last = last_token(tree_, view.id);
    Parts parts;
    append_above(parts, first, begins_block);
    const auto outer = std::pair(std::exchange(first_, first), std::exchange(last_, last));
    parts.push_back(row(table_of(view.kind()), {node_doc(view)}));
    std::tie(first_, last_) = outer;
    if (const Margin& margin = margins_.of(last); !margin.beside.empty()) parts.push_back(comment(margin.beside));
    return concat(std::move(parts));
  }

  /// One by one in lines of their own, between braces; nothing, or `...` alone, in one line.
  Doc block(View view) {
    const std::vector<View> all_parts = parts_of(view);
    const NodeId open = all_parts.front().id, close = all_parts.back().id;
    Parts inside;
    if (is_short_block(all_parts)) {
      for (std::size_t i = 1; i < all_parts.size(); ++i) inside.push_back(space());
      if (all_parts.size() == 3) inside.insert(inside.begin() + 1, token_doc(all_parts[1].id));
      return concat({token_doc(open), concat(std::move(inside)), closing(close)});
    }
    for (std::size_t i = 1; i + 1 < all_parts.size(); ++i) inside.push_back(item(all_parts[i], i == 1));
    append_above(inside, close, inside.empty());
    return concat({token_doc(open), indent(block_indent, std::move(inside)), new_line(), closing(close)});
  }

  bool is_short_block(const std::vector<View>& all_parts) const {
    for (const View part : all_parts) {
      const Margin& margin = margins_.of(last_token(tree_, part.id));
      const bool is_closing = part == all_parts.back();
      if (!margin.above.empty() && part != all_parts.front()) return false;
      if (!margin.beside.empty() && !is_closing) return false;
    }
    return all_parts.size() == 2 || (all_parts.size() == 3 && all_parts[1].kind() == Kind::Ellipsis);
  }

  /// A closing brace, whose comments above stand inside the block.
  Doc closing(NodeId id) {
    const NodeId outer = std::exchange(first_, id);
    Doc doc = token_doc(id);
    first_ = outer;
    return doc;
  }

  // ------------------------------------------------------------------------------------------------ brackets

  /// `{ width 2cm, depth 9cm }`, else all in a line of their own, else a property a line; always so where no comma
  /// stands between two.
  Doc properties(View view) {
    const std::vector<View> all_parts = parts_of(view);
    const View open = all_parts.front(), close = all_parts.back();
    Parts inside;
    for (std::size_t i = 1; i + 1 < all_parts.size(); ++i) {
      const bool is_comma = all_parts[i].kind() == Kind::Comma;
      const Kind before = all_parts[i - 1].kind();
      const bool after_property = i > 1 && (before == Kind::Property || before == Kind::Flag);
      if (!is_comma && i > 1) inside.push_back(after_property ? new_line() : blank_or_break());
      inside.push_back(is_comma ? token_doc(all_parts[i].id) : property(all_parts[i]));
    }
    const Margin& margin = margins_.of(close.id);
    append_comments(inside, margin);
    if (inside.empty()) return concat({token_doc(open.id), space(), closing(close.id)});
    return group({token_doc(open.id), indent(block_indent, {blank_or_break(), group(std::move(inside))}),
                  blank_or_break(), closing(close.id)});
  }

  Doc property(View view) {
    const Margin& margin = margins_.of(first_token(tree_, view.id));
    Parts parts;
    append_comments(parts, margin);
    if (!margin.above.empty()) parts.push_back(new_line());
    const NodeId outer = std::exchange(first_, first_token(tree_, view.id));
    parts.push_back(row(table_of(view.kind()), {node_doc(view)}));
    first_ = outer;
    return concat(std::move(parts));
  }

  /// Brackets and what is in them: in one line, or one by one; short values fill their lines. A comma before the
  /// closing bracket asks for lines of their own.
  Doc bracketed(const std::vector<View>& all_parts, bool fills) {
    const View open = all_parts.front(), close = all_parts.back();
    Parts inside;
    bool trailing_comma = false;
    for (std::size_t i = 1; i + 1 < all_parts.size(); ++i) {
      const View part = all_parts[i];
      trailing_comma = part.kind() == Kind::Comma;
      if (i == 1 && !seems_statement(part)) inside.push_back(nothing_or_break());
      if (i > 1 && !trailing_comma) inside.push_back(fills ? group({break_before(part)}) : break_before(part));
      inside.push_back(part.kind() == Kind::Parameter ? property(part) : node_doc(part));
    }
    append_comments(inside, margins_.of(close.id));
    if (inside.empty()) return concat({token_doc(open.id), closing(close.id)});
    Doc doc =
        group({token_doc(open.id), indent(block_indent, std::move(inside)), nothing_or_break(), closing(close.id)});
    doc.breaks |= trailing_comma;
    return doc;
  }

  Doc call(View view) {
    std::vector<View> all_parts = parts_of(view);
    Doc callee = node_doc(all_parts.front());
    all_parts.erase(all_parts.begin());
    return concat({std::move(callee), bracketed(all_parts, false)});
  }

  static std::vector<View> parts_of(View view) {
    const Children all_children = children(view);
    return {all_children.begin(), all_children.end()};
  }

  // --------------------------------------------------------------------------------------------- expressions

  /// `a + b - c`: operands of operators that bind alike, broken after all of these or none.
  Doc chain(View view) {
    std::vector<View> links = parts_of(view);
    while (links.front().kind() == Kind::Binary && bind_alike(links.front(), view)) {
      std::vector<View> left = parts_of(links.front());
      links.erase(links.begin());
      links.insert(links.begin(), left.begin(), left.end());
    }
    const bool tight = is_tight_power(view);
    Parts parts{node_doc(links.front())}, rest;
    for (std::size_t i = 1; i < links.size(); ++i) {
      const bool is_operator = i % 2 == 1;
      if (!tight) rest.push_back(is_operator ? space() : break_before(links[i]));
      rest.push_back(node_doc(links[i]));
    }
    parts.push_back(indent(hanging_indent, std::move(rest)));
    return group(std::move(parts));
  }

  /// `if … then …`, and each `else` in a line of its own where one line is too short.
  Doc choice(View view) {
    Parts first = clause(view), rest;
    std::optional<View> next = otherwise(view);
    while (next) {
      rest.push_back(blank_or_break());
      rest.push_back(node_doc(*token(view, Kind::KwElse)));
      rest.push_back(space());
      view = *next;
      next.reset();
      if (view.kind() == Kind::If) {
        for (Doc& part : clause(view)) rest.push_back(std::move(part));
        next = otherwise(view);
      } else {
        rest.push_back(node_doc(view));
      }
    }
    first.push_back(indent(hanging_indent, std::move(rest)));
    return group(std::move(first));
  }

  /// `if condition then value`
  Parts clause(View choice) {
    const std::vector<View> all_parts = parts_of(choice);
    Parts value{group({blank_or_break()}), node_doc(all_parts[2]), space(), node_doc(all_parts[3])};
    return {node_doc(all_parts[0]), space(), node_doc(all_parts[1]), indent(hanging_indent, std::move(value))};
  }

  static std::optional<View> otherwise(View choice) { return after<Expr>(choice, Kind::KwElse); }

  /// Not where the next line would look like a statement: that ends what is open.
  Doc break_before(View view) const { return seems_statement(view) ? space() : blank_or_break(); }

  bool seems_statement(View view) const { return may_seem_statement(tree_, source_, first_token(tree_, view.id)); }

  // ------------------------------------------------------------------------------------------------- the rest

  Doc node_doc(View view) {
    switch (view.kind()) {
      case Kind::Block:
        return block(view);
      case Kind::Properties:
        return properties(view);
      case Kind::String:
        return flat({in_line(view)});
      case Kind::Tuple:
      case Kind::RecordLiteral:
      case Kind::Parameters:
        return bracketed(parts_of(view), false);
      case Kind::List:
        return bracketed(parts_of(view), is_list_of_short_values(view));
      case Kind::Call:
      case Kind::Index:
        return call(view);
      case Kind::Binary:
        return chain(view);
      case Kind::If:
        return choice(view);
      default:
        return is_token(view.kind()) ? token_doc(view.id) : in_line(view);
    }
  }

  /// One part behind the other. Where the line may be broken, what comes up to the next such place goes to the next
  /// line if it does not fit into this one.
  Doc in_line(View view) {
    Parts parts, stretch;
    std::optional<View> left;
    bool is_first = true;
    int n = 0;
    for (const View right : children(view)) {
      const bool breaks = left && may_break_between(*left, right) && !seems_statement(right);
      if (breaks) {
        append_stretch(parts, std::exchange(stretch, {}), std::exchange(is_first, false));
        stretch.push_back(blank_or_break());
      }
      Parts next;
      if (!breaks && left && has_blank_between(view, *left, right, source_)) next.push_back(space());
      next.insert(next.end(), static_cast<std::size_t>(stops_before(view, right, n++)), stop());
      next.push_back(node_doc(right));
      const bool hangs = is_first && left && right.kind() != Kind::Block && commented_between(*left, right);
      stretch.push_back(hangs ? indent(hanging_indent, std::move(next)) : concat(std::move(next)));
      left = right;
    }
    append_stretch(parts, std::move(stretch), is_first);
    return concat(std::move(parts));
  }

  static void append_stretch(Parts& parts, Parts stretch, bool is_first) {
    parts.push_back(is_first ? concat(std::move(stretch)) : indent(hanging_indent, {group(std::move(stretch))}));
  }

  const Tree& tree_;
  const Source& source_;
  const Margins margins_;
  NodeId first_ = no_node, last_ = no_node;  // tokens of the statement around
};

}  // namespace

Doc lay_out(const Tree& tree, const Source& source) {
  return Layout(tree, source).file();
}

}  // namespace toile::syntax
