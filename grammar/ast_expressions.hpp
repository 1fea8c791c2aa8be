// Views of expressions; ast.hpp tells how views are used.
#pragma once

#include "grammar/view.hpp"

namespace toile::syntax {

/// Views of one kind of node.
template <Kind K>
struct ViewOf : View {
  static constexpr bool matches(Kind kind) { return kind == K; }
};

/// Any expression; switch over kind() or try as<Binary>(expr) and so on.
/// Kinds: If Binary Unary Member Call Index NameRef Number String Colour Boolean Tuple RecordLiteral List.
struct Expr : View {
  static constexpr bool matches(Kind kind) { return is_expression(kind); }
};

struct If : ViewOf<Kind::If> {
  std::optional<Expr> condition() const { return after<Expr>(*this, Kind::KwIf); }
  std::optional<Expr> then() const { return after<Expr>(*this, Kind::KwThen); }
  std::optional<Expr> otherwise() const { return after<Expr>(*this, Kind::KwElse); }
};

/// left op right; op().kind() is one of KwOr KwAnd Less LessEqual Greater GreaterEqual Equal NotEqual Plus Minus Star
/// Slash Caret. `+ - * /` associate to the left, `^` to the right; comparisons do not chain.
struct Binary : ViewOf<Kind::Binary> {
  std::optional<Expr> left() const { return child<Expr>(*this, 0); }
  std::optional<Token> op() const { return child<Token>(*this); }
  std::optional<Expr> right() const { return child<Expr>(*this, 1); }
};

/// op().kind() is Minus or KwNot. `-a ^ b` is -(a ^ b).
struct Unary : ViewOf<Kind::Unary> {
  std::optional<Token> op() const { return child<Token>(*this); }
  std::optional<Expr> operand() const { return child<Expr>(*this); }
};

/// object.name, as `form.waist.girth`; any word may follow the dot.
struct Member : ViewOf<Kind::Member> {
  std::optional<Expr> object() const { return child<Expr>(*this); }
  std::optional<Token> name() const { return token(*this, Kind::Name); }
};

/// `value`, `name: value`, or `record...` for all of a record's values by their names.
struct Argument : ViewOf<Kind::Argument> {
  bool spread() const { return has(*this, Kind::Ellipsis); }
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Expr> value() const { return child<Expr>(*this); }
};

struct Call : ViewOf<Kind::Call> {
  std::optional<Expr> callee() const { return child<Expr>(*this); }
  std::vector<Argument> arguments() const { return all<Argument>(*this); }
};

/// object[index]
struct Index : ViewOf<Kind::Index> {
  std::optional<Expr> object() const { return child<Expr>(*this, 0); }
  std::optional<Expr> index() const { return child<Expr>(*this, 1); }
};

struct NameRef : ViewOf<Kind::NameRef> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
};

/// `60cm`, `0.65 gf/cm/deg`, `2`: the number and, if written, its unit.
struct Number : ViewOf<Kind::Number> {
  std::optional<Token> digits() const { return token(*this, Kind::Digits); }
  std::optional<Token> unit() const { return token(*this, Kind::Unit); }
};

/// An expression in a text, shown as it is or in a unit: `{w in mm}`.
struct Inserted : ViewOf<Kind::Inserted> {
  std::optional<Expr> value() const { return child<Expr>(*this); }
  std::optional<Token> unit() const { return token(*this, Kind::Unit); }
};

/// Pieces of text, of which string_value() gives the characters, with an Inserted between any two.
struct String : ViewOf<Kind::String> {
  std::vector<Token> pieces() const { return all<Token>(*this); }
  std::vector<Inserted> inserted() const { return all<Inserted>(*this); }
};
struct Colour : ViewOf<Kind::Colour> {};  // the slice is #rgb, #rrggbb or #rrggbbaa
struct Boolean : ViewOf<Kind::Boolean> {
  bool value() const { return has(*this, Kind::KwTrue); }
};

/// `(a)` groups, `(x, y)` is a point, `(x, y, z)` a point in space: one, two or three parts.
struct Tuple : ViewOf<Kind::Tuple> {
  std::vector<Expr> parts() const { return all<Expr>(*this); }
};

/// `(waist: 68cm, hip: 94cm)`: every field has its name. `(waist: 68cm, m...)`: the others are those of `m`.
struct RecordLiteral : ViewOf<Kind::RecordLiteral> {
  std::vector<Argument> fields() const { return all<Argument>(*this); }
};

/// The `for NAME in expr [.. expr] [if expr]` of a list.
struct For : ViewOf<Kind::For> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Expr> from() const { return after<Expr>(*this, Kind::KwIn); }
  std::optional<Expr> to() const { return after<Expr>(*this, Kind::DotDot); }
  std::optional<Expr> condition() const { return after<Expr>(*this, Kind::KwIf); }
};

/// `[a, b]`, or `[a for i in 1..3]`: then elements() has the one expression and generator() is there.
struct List : ViewOf<Kind::List> {
  std::vector<Expr> elements() const { return all<Expr>(*this); }
  std::optional<For> generator() const { return child<For>(*this); }
};

/// The text between the quotes (or braces, for a piece of a text), escapes resolved.
std::string string_value(View piece, const Source& source);

/// The digits as a double, independent of the locale; infinite when too large for one.
double number_value(Token digits, const Source& source);

}  // namespace toile::syntax
