// Typed views of the syntax tree: one small struct a construct, two words each, made from a node and never owning it.
//
//   const Parsed parsed = parse(source);
//   for (View item : items(root(parsed.tree)))              // statements of the file, of a block, of an outline
//     if (auto let = as<Let>(item)) { ... let->name(), let->value() ... }
//
// - Every view has kind(), span() and, being a View, works with as<T>, children(), doc().
// - Accessors give std::optional (or an empty vector): where the text was broken the part is missing, and a SyntaxError
//   tells so. A statement whose keyword was read always has its node, with the parts that were read before the mistake;
//   expressions are whole or absent.
// - Texts are not in the tree: source.slice(view.span()), string_value(), number_value() take the source.
#pragma once

#include "grammar/ast_commands.hpp"
#include "grammar/ast_expressions.hpp"

namespace toile::syntax {

inline View root(const Tree& tree) {
  return {&tree, Tree::root()};
}

/// The statements directly in the file, in a Block, or in the Block of a statement (Garment, Piece, Outline, Fabric,
/// …). Statements are the nodes with is_statement(kind()). Empty when there is no block.
std::vector<View> items(View parent);

// ----------------------------------------------------------------------------------------------------- statements

/// import bodies as b; import "cuffs.toile"
struct Import : ViewOf<Kind::Import> {
  std::optional<Token> module() const { return token(*this, Kind::Name); }  // kind Name, or else:
  std::optional<Token> path() const { return token(*this, Kind::Text); }    // use string_value()
  std::optional<Token> alias() const { return after<Token>(*this, Kind::KwAs); }
};

/// in low .. high
struct Range : ViewOf<Kind::Range> {
  std::optional<Expr> low() const { return after<Expr>(*this, Kind::KwIn); }
  std::optional<Expr> high() const { return after<Expr>(*this, Kind::DotDot); }
};

/// in ["narrow", "wide"]
struct Choices : ViewOf<Kind::Choices> {
  std::optional<Expr> list() const { return child<Expr>(*this); }
};

struct Param : ViewOf<Kind::Param> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Expr> value() const { return child<Expr>(*this); }
  std::optional<Range> range() const { return child<Range>(*this); }
  std::optional<Choices> choices() const { return child<Choices>(*this); }
};

struct Let : ViewOf<Kind::Let> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Expr> value() const { return child<Expr>(*this); }
};

/// NAME in low .. high: what a `solve` looks for.
struct Sought : ViewOf<Kind::Sought> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Range> range() const { return child<Range>(*this); }
};

/// left = right
struct Equation : ViewOf<Kind::Equation> {
  std::optional<Expr> left() const { return child<Expr>(*this, 0); }
  std::optional<Expr> right() const { return child<Expr>(*this, 1); }
};

/// solve h in 8cm..20cm, w in 3cm..9cm so length(cap) = 40cm, w = h / 2
struct Solve : ViewOf<Kind::Solve> {
  std::vector<Sought> unknowns() const { return all<Sought>(*this); }
  std::vector<Equation> equations() const { return all<Equation>(*this); }
};

struct Parameter : ViewOf<Kind::Parameter> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Expr> fallback() const { return child<Expr>(*this); }
};

struct Parameters : ViewOf<Kind::Parameters> {
  std::vector<Parameter> list() const { return all<Parameter>(*this); }
};

/// A block in braces; result() is the last expression of a function's block.
struct Block : ViewOf<Kind::Block> {
  std::optional<Expr> result() const { return child<Expr>(*this); }
};

/// `fn f(a, b = 1cm) = expr`, or with a block of lets and a result.
struct Fn : ViewOf<Kind::Fn> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Parameters> parameters() const { return child<Parameters>(*this); }
  std::optional<Block> block() const { return child<Block>(*this); }  // items() of it are Lets and Solves
  std::optional<Expr> result() const {                                // of either form
    const auto body = block();
    return body ? body->result() : child<Expr>(*this);
  }
};

/// ROWNAME expr { "," expr }: a line of a fabric or textile block.
struct Row : ViewOf<Kind::Row> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::vector<Expr> values() const { return all<Expr>(*this); }
};

/// items() are Rows.
struct Fabric : ViewOf<Kind::Fabric> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Expr> base() const { return after<Expr>(*this, Kind::Assign); }
};

/// items() are Rows.
struct Textile : ViewOf<Kind::Textile> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
};

/// SIZE expr { "," expr }: the measurements of one size.
struct SizeRow : ViewOf<Kind::SizeRow> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::vector<Expr> values() const { return all<Expr>(*this); }
};

/// sizes women(waist, hip) at M { rows }. items() are SizeRows.
struct Sizes : ViewOf<Kind::Sizes> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Parameters> measures() const { return child<Parameters>(*this); }
  std::optional<Token> base() const { return after<Token>(*this, Kind::KwAt); }
};

/// NAME expr between the braces of a body part or a dart.
struct Property : ViewOf<Kind::Property> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Expr> value() const { return child<Expr>(*this); }
};

struct Properties : ViewOf<Kind::Properties> {
  std::vector<Property> list() const { return all<Property>(*this); }
};

/// section waist at 104cm { girth 68cm, width 24cm }
struct BodyPart : ViewOf<Kind::BodyPart> {
  std::optional<Token> role() const { return child<Token>(*this); }  // KwSection, KwLimb, KwLine, or Name: another word
  std::optional<Token> name() const;
  std::optional<Expr> at() const { return after<Expr>(*this, Kind::KwAt); }
  std::vector<Property> properties() const;
};

/// `body form = expr [with { parts }]`, or `body name(parameters) { lets and parts }`. items() are Lets and BodyParts.
struct Body : ViewOf<Kind::Body> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Parameters> parameters() const { return child<Parameters>(*this); }
  std::optional<Expr> base() const { return after<Expr>(*this, Kind::Assign); }
};

/// items() are Lets, Params, Fns, Pieces, Sews, Wears and Arranges.
struct Garment : ViewOf<Kind::Garment> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Parameters> parameters() const { return child<Parameters>(*this); }
  std::optional<Expr> fabric() const { return after<Expr>(*this, Kind::KwIn); }
  std::optional<Expr> textile() const { return after<Expr>(*this, Kind::KwPrinted); }
};

/// `piece name(parameters) { … }`, a variation `piece back = front with { … }`, or `piece cuff = parts.cuff(8cm)`,
/// which may be varied as well. items() are Let Outline Hole InnerLine Fold Cut Grain Dart Notch Pivot Spread Pleat
/// Mark Drill Buttonhole Button Repeat Allowance Label.
struct Piece : ViewOf<Kind::Piece> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Parameters> parameters() const { return child<Parameters>(*this); }
  std::optional<Expr> taken() const { return after<Expr>(*this, Kind::Assign); }   // drawn elsewhere
  std::optional<Expr> on() const { return after<Expr>(*this, Kind::KwOn); }        // drawn on a body, to be developed
  std::optional<Token> base() const { return after<Token>(*this, Kind::Assign); }  // of `piece back = front with`
  bool varies() const { return has(*this, Kind::KwWith); }
};

/// items() are Edges. Without origin() the edges replace those of the varied piece.
struct Outline : ViewOf<Kind::Outline> {
  std::optional<Expr> origin() const { return after<Expr>(*this, Kind::KwFrom); }
};

/// `hole NAME from P { … }` or `line NAME from P { … }`: walked inside of the outline. items() are Edges.
struct Inner : View {
  static constexpr bool matches(Kind kind) { return kind == Kind::Hole || kind == Kind::InnerLine; }

  bool is_line() const { return kind() == Kind::InnerLine; }
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Expr> origin() const { return after<Expr>(*this, Kind::KwFrom); }
};

/// How an edge goes on from the pen; kind() is LineWalk CurveWalk ArcWalk BezierWalk CircleWalk AlongWalk.
struct Walk : View {
  static constexpr bool matches(Kind kind) { return is_walk(kind); }

  bool to_start() const { return has(*this, Kind::KwStart); }
  std::optional<Expr> target() const { return after<Expr>(*this, Kind::KwTo); }  // absent when to_start()
  std::optional<Expr> leaving() const { return after<Expr>(*this, Kind::KwLeaving); }
  std::optional<Expr> arriving() const { return after<Expr>(*this, Kind::KwArriving); }
  std::optional<Expr> through() const { return after<Expr>(*this, Kind::KwThrough); }
  std::optional<Expr> radius() const { return after<Expr>(*this, Kind::KwRadius); }
  std::optional<Expr> wanted_length() const { return after<Expr>(*this, Kind::KwLong); }
  std::vector<Expr> waypoints() const;  // all behind `through`
  bool large() const { return has(*this, Kind::KwLarge); }
  std::optional<Expr> first_control() const { return after<Expr>(*this, Kind::KwVia); }
  std::optional<Expr> second_control() const { return after<Expr>(*this, Kind::Comma); }
  std::optional<Expr> about() const { return after<Expr>(*this, Kind::KwAbout); }
  std::optional<Expr> along() const { return after<Expr>(*this, Kind::KwAlong); }
};

struct Edge : ViewOf<Kind::Edge> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Walk> walk() const { return child<Walk>(*this); }
};

struct Fold : ViewOf<Kind::Fold> {
  std::optional<Token> edge() const { return token(*this, Kind::Name); }
};

struct Cut : ViewOf<Kind::Cut> {
  std::optional<Expr> count() const { return child<Expr>(*this); }
  bool mirrored() const { return has(*this, Kind::KwMirrored); }
  std::optional<Expr> fabric() const { return after<Expr>(*this, Kind::KwIn); }
  std::optional<Expr> plies() const { return after<Expr>(*this, Kind::KwPlies); }
};

/// direction() is KwDown KwUp KwLeft KwRight KwBias KwFree, or else angle() is there.
struct Grain : ViewOf<Kind::Grain> {
  std::optional<Token> direction() const { return child<Token>(*this, 1); }
  std::optional<Expr> angle() const { return child<Expr>(*this); }
};

/// `55% of waist`, `3cm of eye.rim`: how far along which edge.
struct Position : ViewOf<Kind::Position> {
  std::optional<Expr> where() const { return child<Expr>(*this); }
  std::optional<Token> edge() const { return token(*this, Kind::Name); }
  std::vector<Token> path() const;  // of the edge: two names for one of a hole
};

/// `trued`, `tried`, `box`, `pressed left`: a word among the properties of a dart or pleat.
struct Flag : ViewOf<Kind::Flag> {
  std::optional<Token> word() const { return child<Token>(*this); }
  std::optional<Token> direction() const { return child<Token>(*this, 1); }  // KwDown KwUp KwLeft KwRight KwOpen
};

/// On an edge: position(). Inside the piece: from() one point to() another.
struct Dart : ViewOf<Kind::Dart> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Position> position() const { return child<Position>(*this); }
  bool inside() const { return has(*this, Kind::KwFrom); }
  std::optional<Expr> from() const { return after<Expr>(*this, Kind::KwFrom); }
  std::optional<Expr> to() const { return after<Expr>(*this, Kind::KwTo); }
  std::vector<Property> properties() const;
  std::vector<Flag> flags() const;
};

struct Notch : ViewOf<Kind::Notch> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Position> position() const { return child<Position>(*this); }
};

/// pivot bust to 40% of side; pivot 50% of bust to 40% of side as side_dart
struct Pivot : ViewOf<Kind::Pivot> {
  std::optional<Token> dart() const;
  std::optional<Expr> share() const;  // absent for the whole
  std::optional<Position> target() const { return after<Position>(*this, Kind::KwTo); }
  std::optional<Token> alias() const { return after<Token>(*this, Kind::KwAs); }
};

/// spread 4cm at 50% of hem to 40% of waist; spread 4cm at 50% of hem, 2cm at 40% of waist
struct Spread : ViewOf<Kind::Spread> {
  std::optional<Expr> amount() const { return child<Expr>(*this, 0); }
  std::optional<Expr> other_amount() const { return child<Expr>(*this, 1); }  // absent where the line is hinged
  std::optional<Position> opened() const { return child<Position>(*this, 0); }
  std::optional<Position> other() const { return child<Position>(*this, 1); }
};

/// pleat [NAME] at 30% of waist to 35% of hem { box, depth 3cm, width 4cm }
struct Pleat : ViewOf<Kind::Pleat> {
  std::optional<Token> name() const { return token(*this, Kind::Name); }
  std::optional<Position> position() const { return child<Position>(*this, 0); }
  std::optional<Position> other_end() const { return child<Position>(*this, 1); }
  std::vector<Property> properties() const;
  std::vector<Flag> flags() const;
};

/// A line inside the piece.
struct Mark : ViewOf<Kind::Mark> {
  std::optional<Expr> curve() const { return child<Expr>(*this); }
  std::optional<Expr> fold() const { return after<Expr>(*this, Kind::KwFolded); }
};
struct Drill : ViewOf<Kind::Drill> {
  std::optional<Expr> point() const { return child<Expr>(*this); }
};
struct Buttonhole : ViewOf<Kind::Buttonhole> {
  std::optional<Expr> point() const { return child<Expr>(*this); }
  std::vector<Property> properties() const;
};
struct Button : ViewOf<Kind::Button> {
  std::optional<Expr> point() const { return child<Expr>(*this); }
};

/// for i in 1..4 { notch at i * 5cm of side }. items() are Darts, Notches, Pleats, Spreads and marks.
struct Repeat : ViewOf<Kind::Repeat> {
  std::optional<For> values() const { return child<For>(*this); }
};

struct EdgeAllowance : ViewOf<Kind::EdgeAllowance> {
  std::optional<Token> edge() const { return token(*this, Kind::Name); }
  std::vector<Token> path() const;
  std::optional<Expr> width() const { return child<Expr>(*this); }
  std::optional<Token> corner() const;  // KwMitred KwSquare KwMirrored KwBevelled
};

/// allowance 1cm, hem 4cm mirrored
struct Allowance : ViewOf<Kind::Allowance> {
  std::optional<Expr> width() const { return child<Expr>(*this); }
  std::optional<Token> corner() const;
  std::vector<EdgeAllowance> exceptions() const { return all<EdgeAllowance>(*this); }
};

struct Label : ViewOf<Kind::Label> {
  std::optional<Expr> text() const { return child<Expr>(*this); }
};

/// `front.side`, `sleeve.cap.mirrored`: two names or more; `front.side in 0cm..18cm` a part of it.
/// `[3]` behind the name of what a `for` has made.
struct Which : ViewOf<Kind::Which> {
  std::optional<Expr> number() const { return child<Expr>(*this); }
};

struct EdgeRef : ViewOf<Kind::EdgeRef> {
  std::vector<Token> path() const;
  std::optional<Range> range() const { return child<Range>(*this); }
};

struct Chain : ViewOf<Kind::Chain> {
  std::vector<EdgeRef> edges() const { return all<EdgeRef>(*this); }
};

/// word() is KwReversed KwZipped KwButtoned KwOpen; KwEase KwGather KwStretch, which may have an amount() and a
/// range(); KwNotch with places(); KwStep with its number as amount().
struct SewOption : ViewOf<Kind::SewOption> {
  std::optional<Token> word() const { return child<Token>(*this); }
  std::optional<Expr> amount() const { return child<Expr>(*this); }
  std::optional<Range> range() const { return child<Range>(*this); }
  std::vector<Expr> places() const { return all<Expr>(*this); }
};

struct Sew : ViewOf<Kind::Sew> {
  std::optional<Chain> first() const { return after<Chain>(*this, Kind::KwSew); }
  std::optional<Chain> second() const { return after<Chain>(*this, Kind::KwTo); }
  std::vector<Chain> chains() const { return all<Chain>(*this); }  // with further layers behind the second
  std::vector<SewOption> options() const { return all<SewOption>(*this); }
};

/// word() is KwHeld or KwPlaced, or KwFrom with origin().
struct WearOption : ViewOf<Kind::WearOption> {
  std::optional<Token> word() const { return child<Token>(*this); }
  std::optional<Expr> origin() const { return child<Expr>(*this); }
};

struct Wear : ViewOf<Kind::Wear> {
  std::optional<Chain> chain() const { return child<Chain>(*this); }
  std::optional<Expr> line() const { return after<Expr>(*this, Kind::KwAt); }
  std::vector<WearOption> options() const { return all<WearOption>(*this); }
};

/// allow W0410, W0411
struct Allow : ViewOf<Kind::Allow> {
  std::vector<Token> codes() const;
};

/// arrange sleeve at (20cm, 0cm, 120cm) turned (0deg, 40deg, 0deg)
struct Arrange : ViewOf<Kind::Arrange> {
  std::optional<Token> piece() const { return after<Token>(*this, Kind::KwArrange); }
  std::optional<Expr> place() const { return after<Expr>(*this, Kind::KwAt); }
  std::optional<Expr> turn() const { return after<Expr>(*this, Kind::KwTurned); }
};

}  // namespace toile::syntax
