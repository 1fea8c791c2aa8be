// The grammar of statements; docs/grammar.md is its plain text. Seen by parse.cpp, the only file that instantiates it,
// and by the test that analyses it.
#pragma once

#include "grammar/expression_rules.hpp"

namespace toile::syntax::rules {

struct assign : pegtl::seq<sign<Kind::Assign>, more> {};

/// Before an item that may begin with any word: not at a statement of the blocks around, such as `sew a.b to c.d` where
/// the brace of an outline was forgotten.
template <StatementWords Words>
struct not_outside {
  using rule_t = not_outside;
  using subs_t = pegtl::empty_list;
  static bool match(Reader& in) {
    const auto keyword = statement_at(in.text(), in.offset());
    if (!keyword || (in.record.enclosing & Words & statement_word(*keyword)) == 0) return true;
    in.record.expect(Kind::Name, in.offset());
    return false;
  }
};
using not_outside_edges = not_outside<~StatementWords{0}>;
/// Rows and properties may be called `label`, `fold`, `print`, so fewer words count.
using not_outside_rows = not_outside<statement_words(Kind::KwImport, Kind::KwGarment, Kind::KwFabric, Kind::KwPiece,
                                                     Kind::KwSew, Kind::KwWear, Kind::KwDrape, Kind::KwRender,
                                                     Kind::KwExport, Kind::KwExpect, Kind::KwOutline)>;

/// Warnings that are meant to be: of the block around.
struct allow : line<Kind::Allow, word<Kind::KwAllow>, any_name, pegtl::star<comma, any_name>> {};

// ------------------------------------------------------------------------------------------------ definitions

struct import
    : line<Kind::Import, word<Kind::KwImport>, pegtl::sor<any_name, text>, pegtl::opt<word<Kind::KwAs>, any_name>> {};

struct range : node<Kind::Range, word<Kind::KwIn>, expression, sign<Kind::DotDot>, expression> {};
struct before_list {
  using rule_t = before_list;
  using subs_t = pegtl::empty_list;
  static bool match(Reader& in) {
    const std::uint32_t next = skip_blanks(in.text(), in.offset());
    const std::uint32_t open = skip_blanks(in.text(), next + 2);  // behind `in`
    return word_at(in.text(), next) == "in" && open < in.text().size() && in.text()[open] == '[';
  }
};
struct choices : pegtl::seq<before_list, node<Kind::Choices, word<Kind::KwIn>, list>> {};
struct param
    : line<Kind::Param, word<Kind::KwParam>, value_name, assign, expression, pegtl::opt<pegtl::sor<choices, range>>> {};
struct let : line<Kind::Let, word<Kind::KwLet>, value_name, assign, expression> {};

struct sought : node<Kind::Sought, value_name, range> {};
struct equation : node<Kind::Equation, expression, assign, expression> {};
struct solve : line<Kind::Solve, word<Kind::KwSolve>, sought, pegtl::star<comma, sought>,
                    perhaps_on_next_line<Kind::KwSo>, word<Kind::KwSo>, more, equation, pegtl::star<comma, equation>> {
};

struct parameter : node<Kind::Parameter, value_name, pegtl::opt<assign, expression>> {};
struct parameters
    : node<Kind::Parameters, bracketed<Kind::LeftParen, Kind::RightParen,
                                       pegtl::opt<parameter, pegtl::star<comma, parameter>, pegtl::opt<comma>>>> {};

/// The value of a function's block is its last line.
struct at_closing_brace {
  using rule_t = at_closing_brace;
  using subs_t = pegtl::empty_list;
  static bool match(Reader& in) {
    const std::uint32_t at = skip_lines(in.text(), in.offset());
    const bool closing = at == in.text().size() || in.text()[at] == '}';
    if (!closing) in.record.expect(Kind::RightBrace, at);
    return closing;
  }
};
struct fn_block : block<statement_words(Kind::KwLet, Kind::KwSolve),
                        pegtl::sor<let, solve, pegtl::seq<expression, at_end<>, at_closing_brace>>> {};
struct fn : statement<Kind::Fn, word<Kind::KwFn>, to_block<fn_block>, value_name, parameters,
                      pegtl::sor<pegtl::seq<assign, expression>, fn_block>, at_end<>> {};

// ----------------------------------------------------------------------------------------------------- cloths

struct row_name : token<Kind::Name, pegtl::star<pegtl::digit>, pegtl::identifier> {};
struct row : line<Kind::Row, pegtl::seq<not_outside_rows, row_name>, expression, pegtl::star<comma, expression>> {};
struct rows : block<0, row> {};
struct fabric : statement<Kind::Fabric, word<Kind::KwFabric>, to_block<rows>, any_name,
                          pegtl::opt<assign, expression, word<Kind::KwWith>>, rows, at_end<>> {};
struct textile : statement<Kind::Textile, word<Kind::KwTextile>, to_block<rows>, any_name, rows, at_end<>> {};

// ------------------------------------------------------------------------------------------------------ sizes

/// Sizes are called `M`, `2XL`, `38`.
struct size_name : token<Kind::Name, pegtl::plus<pegtl::identifier_other>> {};
struct size_row
    : line<Kind::SizeRow, pegtl::seq<not_outside_rows, size_name>, expression, pegtl::star<comma, expression>> {};
struct size_rows : block<0, size_row> {};
struct sizes : statement<Kind::Sizes, word<Kind::KwSizes>, to_block<size_rows>, value_name, parameters,
                         pegtl::opt<word<Kind::KwAt>, size_name>, size_rows, at_end<>> {};

// ----------------------------------------------------------------------------------------------------- bodies

struct property : statement<Kind::Property, pegtl::seq<not_outside_rows, any_name>, to_comma, expression, at_end<','>> {
};
struct properties : items_in_braces<Kind::Properties, 0, ',', property> {};

template <Kind Next>
struct name_before : pegtl::seq<pegtl::not_at<word<Next>>, any_name> {};

struct part_role : pegtl::sor<word<Kind::KwSection>, word<Kind::KwLimb>, word<Kind::KwLine>, any_name> {};
struct body_part
    : statement<Kind::BodyPart, pegtl::seq<not_outside_rows, part_role>, to_block<properties>,
                pegtl::opt<name_before<Kind::KwAt>>, pegtl::opt<word<Kind::KwAt>, expression>, properties, at_end<>> {};
struct body_block : block<statement_words(Kind::KwLet), pegtl::sor<let, body_part>> {};
struct body : statement<Kind::Body, word<Kind::KwBody>, to_block<body_block>, any_name,
                        pegtl::sor<pegtl::seq<assign, expression, pegtl::opt<word<Kind::KwWith>, body_block>>,
                                   pegtl::seq<pegtl::opt<parameters>, body_block>>,
                        at_end<>> {};

// ----------------------------------------------------------------------------------------------------- pieces

/// `start` closes the outline; a value of that name can still be called or asked for its fields.
struct start : pegtl::seq<word<Kind::KwStart>, pegtl::not_at<pegtl::one<'.', '(', '['>>> {};
/// `leaving 0deg` where the target was forgotten; a value of that name has no other value behind it.
struct clause_word : pegtl::sor<spelled<Kind::KwLeaving>, spelled<Kind::KwArriving>, spelled<Kind::KwThrough>,
                                spelled<Kind::KwRadius>, spelled<Kind::KwVia>, spelled<Kind::KwLong>> {};
struct clause : pegtl::seq<clause_word, pegtl::plus<pegtl::blank>, pegtl::not_at<clause_word>,
                           pegtl::sor<pegtl::digit, pegtl::seq<unreserved, pegtl::identifier>>> {};
struct target : called<Kind::NameRef, pegtl::seq<pegtl::not_at<clause>, pegtl::sor<start, expression>>> {};
template <Kind K>
struct walk_to : pegtl::seq<word<K>, word<Kind::KwTo>, target> {};
template <Kind K>
struct with_value : pegtl::seq<word<K>, expression> {};

struct waypoints : pegtl::seq<with_value<Kind::KwThrough>, pegtl::star<comma, expression>> {};
struct wanted_length : pegtl::opt<with_value<Kind::KwLong>> {};

struct line_walk : node<Kind::LineWalk, walk_to<Kind::KwLine>> {};
struct curve_walk : node<Kind::CurveWalk, walk_to<Kind::KwCurve>,
                         pegtl::star<pegtl::sor<with_value<Kind::KwLeaving>, with_value<Kind::KwArriving>,
                                                with_value<Kind::KwLong>, waypoints>>> {};
struct arc_walk : node<Kind::ArcWalk, walk_to<Kind::KwArc>,
                       pegtl::sor<with_value<Kind::KwThrough>,
                                  pegtl::seq<with_value<Kind::KwRadius>, pegtl::opt<word<Kind::KwLarge>>>>,
                       wanted_length> {};
struct bezier_walk
    : node<Kind::BezierWalk, walk_to<Kind::KwBezier>, with_value<Kind::KwVia>, comma, expression, wanted_length> {};
struct circle_walk : node<Kind::CircleWalk, word<Kind::KwCircle>, with_value<Kind::KwAbout>> {};
struct along_walk : node<Kind::AlongWalk, with_value<Kind::KwAlong>> {};
struct walk : pegtl::sor<line_walk, curve_walk, arc_walk, bezier_walk, circle_walk, along_walk> {};
struct edge : line<Kind::Edge, pegtl::seq<not_outside_edges, any_name>, assign, walk> {};
/// An edge may have any name, `for` too.
struct edge_called_for : gap_before<pegtl::seq<spelled<Kind::KwFor>, sign<Kind::Assign>>> {};
/// The same edges once for each value.
struct repeated_edges : statement<Kind::Repeat, word<Kind::KwFor>, to_block<block<0, edge>>, node<Kind::For, generated>,
                                  block<0, edge>, at_end<>> {};

struct edges : block<0, pegtl::sor<pegtl::seq<pegtl::not_at<edge_called_for>, repeated_edges>, edge>> {};
struct outline : statement<Kind::Outline, word<Kind::KwOutline>, to_block<edges>, pegtl::opt<with_value<Kind::KwFrom>>,
                           edges, at_end<>> {};
struct hole : statement<Kind::Hole, word<Kind::KwHole>, to_block<edges>, pegtl::opt<name_before<Kind::KwFrom>>,
                        with_value<Kind::KwFrom>, edges, at_end<>> {};
/// `line` is a word of edges, too, which in a varied piece may stand alone.
struct inner_line_word : pegtl::seq<word<Kind::KwLine>, pegtl::not_at<pegtl::star<pegtl::blank>, pegtl::one<'='>>> {};
struct inner_line : statement<Kind::InnerLine, inner_line_word, to_block<edges>, name_before<Kind::KwFrom>,
                              with_value<Kind::KwFrom>, edges, at_end<>> {};

/// `side[3]` of what a `for` has made.
struct which : node<Kind::Which, bracketed<Kind::LeftBracket, Kind::RightBracket, expression>> {};
struct numbered_name : pegtl::seq<any_name, pegtl::opt<gap_before<pegtl::at<pegtl::one<'['>>>, which>> {};
/// `hem`, or `eye.rim` for the edge of a hole.
struct edge_name : pegtl::seq<numbered_name, pegtl::star<sign<Kind::Dot>, numbered_name>> {};
struct position : node<Kind::Position, expression, word<Kind::KwOf>, edge_name> {};
struct fold : line<Kind::Fold, word<Kind::KwFold>, any_name> {};
struct cut : line<Kind::Cut, word<Kind::KwCut>, expression, pegtl::opt<word<Kind::KwMirrored>>,
                  pegtl::opt<with_value<Kind::KwIn>>, pegtl::opt<with_value<Kind::KwPlies>>> {};
struct four_ways : pegtl::sor<word<Kind::KwDown>, word<Kind::KwUp>, word<Kind::KwLeft>, word<Kind::KwRight>> {};
struct grain_word : pegtl::sor<four_ways, word<Kind::KwBias>, word<Kind::KwFree>> {};
struct grain : line<Kind::Grain, word<Kind::KwGrain>, pegtl::sor<pegtl::seq<grain_word, at_end<>>, expression>> {};

/// Properties, and words that say enough alone: `{ box, depth 3cm, pressed left }`.
struct lone_word : pegtl::sor<word<Kind::KwTrued>, word<Kind::KwTried>, word<Kind::KwKnife>, word<Kind::KwBox>,
                              word<Kind::KwInverted>> {};
struct flag : statement<Kind::Flag, lone_word, to_comma, at_end<','>> {};
struct pressed
    : statement<Kind::Flag, word<Kind::KwPressed>, to_comma, pegtl::sor<four_ways, word<Kind::KwOpen>>, at_end<','>> {};
struct details : items_in_braces<Kind::Properties, 0, ',', pegtl::sor<flag, pressed, property>> {};

struct dart_name : pegtl::opt<pegtl::not_at<pegtl::sor<word<Kind::KwAt>, word<Kind::KwFrom>>>, any_name> {};
struct on_edge : pegtl::seq<word<Kind::KwAt>, position> {};
struct inside : pegtl::seq<with_value<Kind::KwFrom>, with_value<Kind::KwTo>> {};
struct dart : statement<Kind::Dart, word<Kind::KwDart>, to_block<details>, dart_name, pegtl::sor<inside, on_edge>,
                        details, at_end<>> {};
struct notch : line<Kind::Notch, word<Kind::KwNotch>, pegtl::opt<name_before<Kind::KwAt>>, on_edge> {};
struct share_of_dart : pegtl::sor<pegtl::seq<any_name, pegtl::at<word<Kind::KwTo>>>, position> {};
struct pivot : line<Kind::Pivot, word<Kind::KwPivot>, share_of_dart, word<Kind::KwTo>, position,
                    pegtl::opt<word<Kind::KwAs>, any_name>> {};
struct spread : line<Kind::Spread, word<Kind::KwSpread>, expression, on_edge,
                     pegtl::sor<pegtl::seq<word<Kind::KwTo>, position>, pegtl::seq<comma, expression, on_edge>>> {};
struct pleat : statement<Kind::Pleat, word<Kind::KwPleat>, to_block<details>, pegtl::opt<name_before<Kind::KwAt>>,
                         on_edge, pegtl::opt<word<Kind::KwTo>, position>, details, at_end<>> {};
struct mark : line<Kind::Mark, word<Kind::KwMark>, expression, pegtl::opt<with_value<Kind::KwFolded>>> {};
struct drill : line<Kind::Drill, word<Kind::KwDrill>, with_value<Kind::KwAt>> {};
struct buttonhole : statement<Kind::Buttonhole, word<Kind::KwButtonhole>, to_block<properties>, with_value<Kind::KwAt>,
                              properties, at_end<>> {};
struct button : line<Kind::Button, word<Kind::KwButton>, with_value<Kind::KwAt>> {};
struct detail : pegtl::sor<dart, notch, pleat, spread, mark, drill, buttonhole, button> {};
struct repeated : block<repeated_words, detail> {};
struct repeat
    : statement<Kind::Repeat, word<Kind::KwFor>, to_block<repeated>, node<Kind::For, generated>, repeated, at_end<>> {};
struct corner : pegtl::sor<word<Kind::KwMitred>, word<Kind::KwSquare>, word<Kind::KwMirrored>, word<Kind::KwBevelled>> {
};
struct edge_allowance : node<Kind::EdgeAllowance, edge_name, expression, pegtl::opt<corner>> {};
struct allowance : line<Kind::Allowance, word<Kind::KwAllowance>, expression, pegtl::opt<corner>,
                        pegtl::star<comma, edge_allowance>> {};
struct label : line<Kind::Label, word<Kind::KwLabel>, expression> {};

/// "And the rest as before": what a varied piece does not mention it has from its model, said or unsaid.
struct and_so_on : sign<Kind::Ellipsis> {};
struct piece_item : pegtl::sor<and_so_on, outline, let, solve, fold, detail, pivot, grain, allowance, cut, label, hole,
                               inner_line, repeat, allow> {};
struct piece_block : block<piece_words, piece_item> {};
struct piece
    : statement<Kind::Piece, word<Kind::KwPiece>, to_block<piece_block>, any_name,
                pegtl::sor<
                    pegtl::seq<assign, pegtl::sor<pegtl::seq<any_name, word<Kind::KwWith>, piece_block>,
                                                  pegtl::seq<expression, pegtl::opt<word<Kind::KwWith>, piece_block>>>>,
                    pegtl::seq<pegtl::opt<parameters>, pegtl::opt<with_value<Kind::KwOn>>,
                               pegtl::opt<assign, pegtl::sor<pegtl::seq<any_name, word<Kind::KwWith>>,
                                                             pegtl::seq<expression, word<Kind::KwWith>>>>,
                               piece_block>>,
                at_end<>> {};

// --------------------------------------------------------------------------------------------------- garments

struct part : node<Kind::Range, word<Kind::KwIn>, expression, sign<Kind::DotDot>, end_of_part> {};
struct edge_ref
    : called<Kind::EdgeRef,
             node<Kind::EdgeRef, numbered_name, pegtl::plus<sign<Kind::Dot>, numbered_name>, pegtl::opt<part>>> {};
struct chain : node<Kind::Chain, edge_ref, pegtl::star<sign<Kind::Plus>, more, edge_ref>> {};

struct difference : pegtl::sor<word<Kind::KwEase>, word<Kind::KwGather>, word<Kind::KwStretch>> {};
struct plain_sew_word
    : pegtl::sor<word<Kind::KwReversed>, word<Kind::KwZipped>, word<Kind::KwButtoned>, word<Kind::KwOpen>> {};
struct sew_word
    : pegtl::sor<plain_sew_word, difference, word<Kind::KwNotch>, word<Kind::KwStep>, word<Kind::KwFolded>> {};
struct fullness
    : pegtl::seq<difference, pegtl::opt<pegtl::not_at<sew_word>, pegtl::not_at<word<Kind::KwIn>>, expression>,
                 pegtl::opt<range>> {};
struct tied_notches : pegtl::seq<word<Kind::KwNotch>, with_value<Kind::KwAt>, pegtl::star<comma, expression>> {};
struct sew_option
    : node<Kind::SewOption,
           pegtl::sor<plain_sew_word, fullness, tied_notches, with_value<Kind::KwStep>, with_value<Kind::KwFolded>>> {};
struct sew : line<Kind::Sew, word<Kind::KwSew>, chain, pegtl::plus<word<Kind::KwTo>, chain>, pegtl::star<sew_option>> {
};

struct wear_option
    : node<Kind::WearOption, pegtl::sor<word<Kind::KwHeld>, word<Kind::KwPlaced>, with_value<Kind::KwFrom>>> {};
struct wear : line<Kind::Wear, word<Kind::KwWear>, chain, word<Kind::KwAt>, expression, pegtl::star<wear_option>> {};

struct arrange : line<Kind::Arrange, word<Kind::KwArrange>, numbered_name, word<Kind::KwAt>, expression,
                      pegtl::opt<with_value<Kind::KwTurned>>> {};

/// Pieces, and what joins them, once for each value.
struct garment_repeated_item;
struct garment_repeated : block<statement_words(Kind::KwLet, Kind::KwPiece, Kind::KwSew, Kind::KwWear, Kind::KwArrange),
                                garment_repeated_item> {};
struct garment_repeat : statement<Kind::Repeat, word<Kind::KwFor>, to_block<garment_repeated>,
                                  node<Kind::For, generated>, garment_repeated, at_end<>> {};
struct garment_repeated_item : pegtl::sor<let, piece, sew, wear, arrange, garment_repeat> {};

struct garment_item : pegtl::sor<let, solve, piece, sew, wear, arrange, param, fn, allow, garment_repeat> {};
struct garment_block : block<garment_words, garment_item> {};
struct garment
    : statement<Kind::Garment, word<Kind::KwGarment>, to_block<garment_block>, any_name, pegtl::opt<parameters>,
                pegtl::opt<with_value<Kind::KwIn>>, pegtl::opt<with_value<Kind::KwPrinted>>, garment_block, at_end<>> {
};

// --------------------------------------------------------------------------------------------------- commands

struct drape : line<Kind::Drape, word<Kind::KwDrape>, expression, pegtl::star<with_value<Kind::KwOver>>,
                    pegtl::opt<with_value<Kind::KwOn>>, pegtl::opt<word<Kind::KwAs>, any_name>,
                    pegtl::opt<with_value<Kind::KwTo>>> {};
struct develop : line<Kind::Develop, word<Kind::KwDevelop>, expression, pegtl::opt<word<Kind::KwAs>, any_name>,
                      pegtl::opt<word<Kind::KwWith>, word<Kind::KwDarts>, with_value<Kind::KwTo>>,
                      pegtl::opt<word<Kind::KwUntil>, with_value<Kind::KwWithin>>> {};
struct render_option
    : node<Kind::RenderOption,
           pegtl::sor<pegtl::seq<word<Kind::KwFrom>, any_name>,
                      pegtl::seq<word<Kind::KwShowing>, any_name, pegtl::star<sign<Kind::Dot>, any_name>>,
                      pegtl::seq<with_value<Kind::KwPixels>, comma, expression>>> {};
struct render
    : line<Kind::Render, word<Kind::KwRender>, expression, word<Kind::KwTo>, expression, pegtl::star<render_option>> {};
struct export_ : line<Kind::Export, word<Kind::KwExport>, expression, word<Kind::KwTo>, expression> {};
struct print : line<Kind::Print, word<Kind::KwPrint>, expression, pegtl::star<comma, expression>> {};
struct expect : line<Kind::Expect, word<Kind::KwExpect>, expression> {};

struct file_item : pegtl::sor<let, param, solve, fn, import, garment, piece, fabric, textile, sizes, body, drape,
                              develop, render, export_, print, expect, allow> {};

/// Statements to the end of the text. Always succeeds.
struct file {
  using rule_t = file;
  using subs_t = pegtl::type_list<pegtl::star<file_item>>;
  static bool match(Reader& in) {
    in.record.enclosing = file_words;
    Items<file_item, '\n'>(in, Record::nowhere).read();
    return true;
  }
};

/// One expression, and nothing else but white space around it. Always succeeds.
struct lone_expression {
  using rule_t = lone_expression;
  using subs_t = pegtl::type_list<expression>;
  static bool match(Reader& in) {
    in.go_to(skip_lines(in.text(), in.offset()));
    const bool read = run<expression>(in);
    const std::uint32_t rest = skip_lines(in.text(), in.offset());
    if (read && rest == in.text().size()) return true;
    if (read) in.record.expect(Kind::Newline, rest);
    (void)in.record.report_failure(rest);
    if (rest < in.text().size()) in.record.token(Kind::Error, {rest, static_cast<std::uint32_t>(in.text().size())});
    return true;
  }
};

}  // namespace toile::syntax::rules
