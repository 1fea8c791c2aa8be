#include "compiler/evaluate/literals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "compiler/evaluate/expression.hpp"
#include "compiler/units/format.hpp"
#include "compiler/units/unit.hpp"

namespace toile {
namespace {

/// The value as a number of that unit; nothing after an error.
std::optional<std::string> shown_in_unit(Session& session, const Module& module, const Value& value,
                                         const syntax::Inserted& written) {
  const syntax::Token token = *written.unit();
  const std::string_view name = session.text(module, token);
  const Unit unit = parse_unit(name).value_or(Unit{});  // the grammar lets through nothing else
  const auto* quantity = value.as<Quantity>();
  if (quantity == nullptr || quantity->dimension != unit.dimension) {
    session.report.add(Problem("E0201", fmt::format("{} cannot be shown in `{}`", describe(value), name))
                           .at(module.at(*written.value()), describe(value))
                           .at(module.at(token)));
    return std::nullopt;
  }
  return format_number(quantity->si / unit.factor) + " " + std::string(name);
}

}  // namespace

Value written_text(Session& session, const Scope& scope, const syntax::String& written) {
  const Module& module = scope.module();
  const Source& source = session.sources[module.file];
  const std::vector<syntax::Token> pieces = written.pieces();
  std::string text = pieces.empty() ? "" : syntax::string_value(pieces.front(), source);
  bool sound = true;
  bool known = true;
  std::size_t next_piece = 1;
  for (const syntax::Inserted& inserted : written.inserted()) {
    const Value value = evaluate(session, scope, inserted.value());
    std::optional<std::string> shown;
    if (!value.unknown()) shown = inserted.unit() ? shown_in_unit(session, module, value, inserted) : format(value);
    sound = sound && shown.has_value();
    known = known && value.known();
    text += shown.value_or("");
    if (next_piece < pieces.size()) text += syntax::string_value(pieces[next_piece++], source);
  }
  return sound ? Value{Text{text}, known} : Value{};
}

Value written_colour(const Session& session, const Module& module, const syntax::Expr& literal) {
  std::string_view hex = session.text(module, literal);
  hex.remove_prefix(std::min<std::size_t>(1, hex.size()));
  const std::size_t digits = hex.size() <= 4 ? 1 : 2;
  std::array<std::uint8_t, 3> channels{};
  for (std::size_t i = 0; i < 3 && (i + 1) * digits <= hex.size(); ++i) {
    const char* begin = hex.data() + i * digits;
    std::from_chars(begin, begin + digits, channels[i], 16);
    if (digits == 1) channels[i] = static_cast<std::uint8_t>(channels[i] * 17);
  }
  return Colour{channels[0], channels[1], channels[2]};
}

}  // namespace toile
