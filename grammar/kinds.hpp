// The kinds of nodes and tokens of the syntax tree; the list itself is kinds.def.
#pragma once

#include <cstdint>
#include <string_view>

namespace toile::syntax {

enum class Kind : std::uint8_t {
#define TOILE_NODE(name, words) name,
#define TOILE_TOKEN(name, words) name,
#define TOILE_WORD(name, spelling) name,
#define TOILE_SIGN(name, spelling) name,
#include "grammar/kinds.def"
};

inline constexpr int kind_count = static_cast<int>(Kind::NotEqual) + 1;

/// The name of a node or token ("Piece", "Name"); for keywords and signs their spelling ("sew", "<=").
std::string_view name(Kind kind);

/// What a keyword or sign looks like in the text, empty for all other kinds.
constexpr std::string_view spelling(Kind kind) {
  switch (kind) {
#define TOILE_WORD(name, spelling) \
  case Kind::name:                 \
    return spelling;
#define TOILE_SIGN(name, spelling) \
  case Kind::name:                 \
    return spelling;
#include "grammar/kinds.def"
    default:
      return {};
  }
}

/// How messages call a token that was expected: "a name", "`sew`", "`)`". Of nodes only a few have words: "a value",
/// "an operator".
std::string_view expectation(Kind kind);

constexpr bool is_trivia(Kind kind) {
  return kind >= Kind::Space && kind <= Kind::DocComment;
}
constexpr bool is_keyword(Kind kind) {
  return kind >= Kind::KwImport && kind <= Kind::KwFalse;
}
constexpr bool is_sign(Kind kind) {
  return kind >= Kind::LeftParen;
}
constexpr bool is_token(Kind kind) {
  return kind <= Kind::Hex || is_keyword(kind) || is_sign(kind);
}
constexpr bool is_statement(Kind kind) {
  return kind >= Kind::Import && kind <= Kind::Property;
}
constexpr bool is_walk(Kind kind) {
  return kind >= Kind::LineWalk && kind <= Kind::AlongWalk;
}
constexpr bool is_expression(Kind kind) {
  return kind >= Kind::If && kind <= Kind::List;
}

}  // namespace toile::syntax
