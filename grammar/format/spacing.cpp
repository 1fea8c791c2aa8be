#include "grammar/format/spacing.hpp"

#include <algorithm>

#include "grammar/ast.hpp"
#include "grammar/words.hpp"

namespace toile::syntax {
namespace {

/// 1 for sums, 2 for products, …; 0 for operators that do not chain.
int binding(View binary) {
  switch (child<Token>(binary)->kind()) {
    case Kind::Plus:
    case Kind::Minus:
      return 1;
    case Kind::Star:
    case Kind::Slash:
      return 2;
    case Kind::KwAnd:
      return 3;
    case Kind::KwOr:
      return 4;
    default:
      return 0;
  }
}

bool is_short_value(View view) {
  switch (view.kind()) {
    case Kind::Number:
    case Kind::String:
    case Kind::Colour:
    case Kind::Boolean:
    case Kind::NameRef:
      return true;
    case Kind::Unary:
      return is_short_value(*child<Expr>(view));
    default:
      return false;
  }
}

/// `cm` stands right behind its number, `mg/cm^2` apart from it.
bool is_compound(View unit, const Source& source) {
  return source.slice(unit.span()).find_first_of("*/^") != std::string_view::npos;
}

bool is_opening(Kind kind) {
  return kind == Kind::LeftParen || kind == Kind::LeftBracket;
}
bool is_closing(Kind kind) {
  return kind == Kind::RightParen || kind == Kind::RightBracket;
}

bool begins_statements(std::string_view word) {
  for (int i = static_cast<int>(Kind::KwImport); i <= static_cast<int>(Kind::KwExpect); ++i) {
    if (spelling(static_cast<Kind>(i)) == word) return true;
  }
  return false;
}

}  // namespace

Table table_of(Kind kind) {
  switch (kind) {
    case Kind::Let:
      return Table::Let;
    case Kind::Param:
      return Table::Param;
    case Kind::Edge:
      return Table::Edge;
    case Kind::Parameter:
      return Table::Parameter;
    case Kind::Drape:
    case Kind::Develop:
    case Kind::Render:
    case Kind::Export:
    case Kind::Print:
    case Kind::Expect:
      return Table::Command;
    case Kind::Sew:
    case Kind::Wear:
      return Table::Seam;
    case Kind::Fold:
    case Kind::Cut:
    case Kind::Grain:
    case Kind::Dart:
    case Kind::Notch:
    case Kind::Pivot:
    case Kind::Spread:
    case Kind::Pleat:
    case Kind::Mark:
    case Kind::Drill:
    case Kind::Button:
    case Kind::Buttonhole:
    case Kind::Label:
    case Kind::Arrange:
      return Table::Detail;
    case Kind::BodyPart:
      return Table::Part;
    case Kind::Row:
    case Kind::Property:
      return Table::Measure;
    case Kind::SizeRow:
      return Table::Size;
    default:
      return Table::None;
  }
}

int stops_before(View statement, View part, int n) {
  switch (table_of(statement.kind())) {
    case Table::None:
      return 0;
    case Table::Let:
    case Table::Param:
    case Table::Edge:
    case Table::Parameter:
      return part.kind() == Kind::Assign ? 1 : 0;
    case Table::Command:
    case Table::Detail:
      return n == 1 ? 1 : 0;
    case Table::Seam:
      return n == 1 || part.kind() == Kind::KwTo ? 1 : 0;
    case Table::Measure:
      return n == 1 && part.kind() != Kind::String ? 1 : 0;
    case Table::Size:
      return n > 0 && part.kind() != Kind::Comma ? 1 : 0;
    case Table::Part: {
      // Role, name, place, properties: a part that is missing leaves its column empty.
      const bool has_name = as<BodyPart>(statement)->name().has_value();
      if (n == 1) return has_name ? 1 : part.kind() == Kind::KwAt ? 2 : 3;
      if (part.kind() == Kind::KwAt) return 1;
      if (part.kind() == Kind::Properties) return has(statement, Kind::KwAt) ? 1 : 2;
      return 0;
    }
  }
  return 0;
}

bool has_blank_between(View parent, View left, View right, const Source& source) {
  if (right.kind() == Kind::Comma || right.kind() == Kind::Colon || right.kind() == Kind::Parameters) return false;
  if (right.kind() == Kind::Which) return false;
  if (left.kind() == Kind::Dot || right.kind() == Kind::Dot) return false;
  if (left.kind() == Kind::DotDot || right.kind() == Kind::DotDot || right.kind() == Kind::Ellipsis) return false;
  if (parent.kind() == Kind::Unary) return left.kind() != Kind::Minus;
  if (parent.kind() == Kind::Number) return is_compound(right, source);
  if (parent.kind() == Kind::String) return false;
  return !is_opening(left.kind()) && !is_closing(right.kind());
}

bool may_break_between(View left, View right) {
  return left.kind() == Kind::Comma || left.kind() == Kind::Plus || right.kind() == Kind::KwSo;
}

bool is_tight_power(View binary) {
  if (child<Token>(binary)->kind() != Kind::Caret) return false;
  const Expr base = *child<Expr>(binary, 0), exponent = *child<Expr>(binary, 1);
  const auto is_plain = [](Expr value) {
    return value.kind() == Kind::NameRef || (value.kind() == Kind::Number && !has(value, Kind::Unit));
  };
  const bool is_closed = base.kind() == Kind::Member || base.kind() == Kind::Tuple || base.kind() == Kind::Call;
  return (is_plain(base) || is_closed) && is_plain(exponent);
}

bool bind_alike(View binary, View other) {
  return binding(binary) != 0 && binding(binary) == binding(other);
}

bool is_list_of_short_values(View list) {
  return !child<For>(list) && std::ranges::all_of(all<Expr>(list), is_short_value);
}

bool may_seem_statement(const Tree& tree, const Source& source, NodeId token) {
  if (!begins_statements(source.slice(tree[token].span))) return false;
  NodeId next = token + 1;  // tokens are numbered in the order of the text
  while (next < tree.size() && (!is_token(tree[next].kind) || is_trivia(tree[next].kind))) ++next;
  if (next == tree.size()) return false;
  const Kind kind = tree[next].kind;
  return kind == Kind::Name || kind == Kind::Text || is_keyword(kind);
}

}  // namespace toile::syntax
