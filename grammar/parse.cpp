#include "grammar/parse.hpp"

#include <algorithm>
#include <iterator>

#include "grammar/build.hpp"
#include "grammar/rules.hpp"

namespace toile::syntax {
namespace {

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && c != '\t' && c != '\r') || byte == 0x7f;
}

/// Bytes that no text has: the first run of them on every line, for in comments and quotes the grammar reads over them.
std::vector<SyntaxError> find_bad_bytes(std::string_view text) {
  std::vector<SyntaxError> errors;
  const auto bad = [&](std::uint32_t at) { return is_control(text[at]) || code_point_length(text, at) == 0; };
  for (std::uint32_t at = 0; at < text.size();) {
    if (text[at] >= ' ' && text[at] < '\x7f') {
      ++at;
    } else if (!bad(at)) {
      at += code_point_length(text, at);
    } else {
      std::uint32_t end = at + 1;
      while (end < text.size() && bad(end)) ++end;
      errors.push_back({SyntaxError::What::BadToken, {at, end}, {}, {}});
      at = static_cast<std::uint32_t>(std::min(text.find('\n', end), text.size()));
    }
  }
  return errors;
}

/// In the order of the text; where a bad byte was the reason, that is said once.
std::vector<SyntaxError> in_order(std::vector<SyntaxError> errors, std::vector<SyntaxError> bad_bytes) {
  errors.insert(errors.begin(), std::make_move_iterator(bad_bytes.begin()), std::make_move_iterator(bad_bytes.end()));
  std::ranges::stable_sort(errors, {}, [](const SyntaxError& error) { return error.span.begin; });
  const auto same_place = [](const SyntaxError& a, const SyntaxError& b) { return a.span.begin == b.span.begin; };
  errors.erase(std::unique(errors.begin(), errors.end(), same_place), errors.end());
  return errors;
}

template <typename Rule>
Parsed parse_as(const Source& source) {
  Reader reader(source.text());
  (void)run<Rule>(reader);
  Tree tree = build_tree(source.text(), reader.record.events());
  return {std::move(tree), in_order(std::move(reader.record.errors()), find_bad_bytes(source.text()))};
}

}  // namespace

Parsed parse(const Source& source) {
  return parse_as<rules::file>(source);
}

Parsed parse_expression(const Source& source) {
  return parse_as<rules::lone_expression>(source);
}

}  // namespace toile::syntax
