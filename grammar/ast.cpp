#include "grammar/ast.hpp"

#include <charconv>
#include <cmath>

namespace toile::syntax {
namespace {

std::vector<Token> names_of(View parent) {
  std::vector<Token> names;
  for (const Token leaf : all<Token>(parent)) {
    if (leaf.kind() == Kind::Name) names.push_back(leaf);
  }
  return names;
}

std::vector<Property> properties_of(View parent) {
  const auto properties = child<Properties>(parent);
  return properties ? properties->list() : std::vector<Property>{};
}

std::vector<Flag> flags_of(View parent) {
  const auto properties = child<Properties>(parent);
  return properties ? all<Flag>(*properties) : std::vector<Flag>{};
}

std::optional<Token> corner_of(View parent) {
  for (const Kind word : {Kind::KwMitred, Kind::KwSquare, Kind::KwMirrored, Kind::KwBevelled}) {
    if (const auto found = token(parent, word)) return found;
  }
  return std::nullopt;
}

}  // namespace

std::vector<View> items(View parent) {
  if (parent.kind() != Kind::File && parent.kind() != Kind::Block) {
    const auto block = child<Block>(parent);
    return block ? items(*block) : std::vector<View>{};
  }
  std::vector<View> found;
  for (const View view : children(parent)) {
    if (is_statement(view.kind())) found.push_back(view);
  }
  return found;
}

std::vector<Token> Allow::codes() const {
  return names_of(*this);
}

std::string string_value(View piece, const Source& source) {
  std::string_view text = source.slice(piece.span());
  if (text.size() < 2) return {};
  text = text.substr(1, text.size() - 2);
  std::string value;
  value.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      value += text[i];
      continue;
    }
    ++i;
    value += text[i] == 'n' ? '\n' : text[i];
  }
  return value;
}

double number_value(Token digits, const Source& source) {
  const std::string_view text = source.slice(digits.span());
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec == std::errc::result_out_of_range && text.find('-') == std::string_view::npos) return HUGE_VAL;
  return value;
}

std::optional<Token> BodyPart::name() const {
  const auto first = child<Token>(*this, 0);
  const auto second = child<Token>(*this, 1);
  const bool named = first && second && second->kind() == Kind::Name;
  return named ? second : std::nullopt;
}

std::vector<Property> BodyPart::properties() const {
  return properties_of(*this);
}
std::vector<Property> Dart::properties() const {
  return properties_of(*this);
}
std::vector<Flag> Dart::flags() const {
  return flags_of(*this);
}
std::vector<Property> Pleat::properties() const {
  return properties_of(*this);
}
std::vector<Flag> Pleat::flags() const {
  return flags_of(*this);
}
std::vector<Property> Buttonhole::properties() const {
  return properties_of(*this);
}
std::vector<Token> Position::path() const {
  return names_of(*this);
}
std::vector<Token> EdgeAllowance::path() const {
  return names_of(*this);
}
std::optional<Token> EdgeAllowance::corner() const {
  return corner_of(*this);
}
std::optional<Token> Allowance::corner() const {
  return corner_of(*this);
}
std::optional<Token> Pivot::dart() const {
  // Either a name stands before `to`, or a share of it.
  const std::vector<Position> positions = all<Position>(*this);
  if (positions.size() > 1) return positions.front().edge();
  const auto second = child<Token>(*this, 1);
  return second && second->kind() == Kind::Name ? second : std::nullopt;
}
std::optional<Expr> Pivot::share() const {
  const std::vector<Position> positions = all<Position>(*this);
  return positions.size() > 1 ? positions.front().where() : std::nullopt;
}
std::vector<Expr> Walk::waypoints() const {
  std::vector<Expr> points;
  bool through = false;
  for (const View part : children(*this)) {
    if (is_keyword(part.kind())) through = part.kind() == Kind::KwThrough;
    if (const auto point = as<Expr>(part); point && through) points.push_back(*point);
  }
  return points;
}
std::vector<Token> EdgeRef::path() const {
  return names_of(*this);
}
std::vector<Expr> Drape::over() const {
  std::vector<Expr> found;
  bool marked = false;
  for (const View view : children(*this)) {
    if (const auto expr = as<Expr>(view); expr && marked) found.push_back(*expr);
    marked = view.kind() == Kind::KwOver;
  }
  return found;
}

std::vector<Token> RenderOption::names() const {
  return names_of(*this);
}

}  // namespace toile::syntax
