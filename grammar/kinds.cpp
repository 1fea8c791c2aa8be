#include "grammar/kinds.hpp"

#include <array>

namespace toile::syntax {
namespace {

struct Words {
  std::string_view name;
  std::string_view expectation;
};

constexpr std::array<Words, kind_count> words_of_kind{{
#define TOILE_NODE(name, words) {#name, words},
#define TOILE_TOKEN(name, words) {#name, words},
#define TOILE_WORD(name, spelling) {spelling, "`" spelling "`"},
#define TOILE_SIGN(name, spelling) {spelling, "`" spelling "`"},
#include "grammar/kinds.def"
}};

constexpr const Words& of(Kind kind) {
  return words_of_kind[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string_view name(Kind kind) {
  return of(kind).name;
}
std::string_view expectation(Kind kind) {
  return of(kind).expectation;
}

}  // namespace toile::syntax
