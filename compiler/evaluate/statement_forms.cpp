#include "compiler/evaluate/statement_forms.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "grammar/words.hpp"

namespace toile {
namespace {

using Form = std::pair<std::string_view, std::string_view>;

constexpr std::array forms{
    Form{"allow", "allow W0410"},
    Form{"allowance", "allowance 1cm, hem 4cm mirrored"},
    Form{"along", "NAME = along CURVE"},
    Form{"arc", "NAME = arc to POINT through POINT, or: NAME = arc to POINT radius LENGTH"},
    Form{"arrange", "arrange PIECE at (X, Y, Z) turned (A, B, C)"},
    Form{"bezier", "NAME = bezier to POINT via POINT, POINT"},
    Form{"body", "body NAME = BODY, or: body NAME(PARAMETERS) { section NAME at LEVEL { girth LENGTH } }"},
    Form{"button", "button at POINT"},
    Form{"buttonhole", "buttonhole at POINT { length 1.5cm }"},
    Form{"circle", "NAME = circle about POINT"},
    Form{"curve", "NAME = curve to POINT leaving ANGLE arriving ANGLE"},
    Form{"cut", "cut 2 mirrored, then in FABRIC or plies 2"},
    Form{"dart", "dart NAME at PLACE of EDGE { width 3cm, depth 9cm }"},
    Form{"develop", "develop GARMENT as NAME until within 3mm"},
    Form{"drape", "drape GARMENT on BODY as NAME, or: drape JACKET over SHIRT on BODY as NAME"},
    Form{"drill", "drill at POINT"},
    Form{"expect", "expect VALUE < VALUE"},
    Form{"export", "export NAME to \"file.svg\""},
    Form{"fabric", "fabric NAME { W 19.2 mg/cm^2 }, a row a line"},
    Form{"fn", "fn NAME(PARAMETERS) = VALUE"},
    Form{"fold", "fold EDGE"},
    Form{"garment", "garment NAME(PARAMETERS) in FABRIC printed TEXTILE { ... }"},
    Form{"grain", "grain down, or up, left, right, bias, or an angle"},
    Form{"hole", "hole NAME from POINT { ... }"},
    Form{"import", "import NAME, or: import \"file.toile\" as NAME"},
    Form{"label", "label \"TEXT\""},
    Form{"let", "let NAME = VALUE"},
    Form{"line", "NAME = line to POINT"},
    Form{"mark", "mark CURVE, or: mark LINE folded 90deg"},
    Form{"notch", "notch at PLACE of EDGE"},
    Form{"outline", "outline from POINT { ... }, an edge a line"},
    Form{"param", "param NAME = VALUE in LOW..HIGH"},
    Form{"piece", "piece NAME { ... }, or: piece NAME = OTHER with { ... }"},
    Form{"pivot", "pivot DART to PLACE of EDGE"},
    Form{"pleat", "pleat NAME at PLACE of EDGE { knife, depth 3cm }"},
    Form{"print", "print VALUE, VALUE"},
    Form{"render", "render NAME to \"file.png\" from front showing FIELD"},
    Form{"sew",
         "sew PIECE.EDGE + PIECE.EDGE to PIECE.EDGE, then reversed, ease, gather, stretch, notch at, zipped, "
         "buttoned, open or step"},
    Form{"sizes", "sizes NAME(MEASURES) at SIZE { ... }, a size a line"},
    Form{"solve", "solve NAME in LOW..HIGH so VALUE = VALUE"},
    Form{"spread", "spread 4cm at PLACE of EDGE to PLACE of EDGE"},
    Form{"textile", "textile NAME { warp 8, #1f3a5f }, a row a line"},
    Form{"wear", "wear PIECE.EDGE + PIECE.EDGE at BODY.LINE placed"},
};

std::string_view form_called(std::string_view word) {
  const auto found = std::ranges::lower_bound(forms, word, {}, &Form::first);
  return found != forms.end() && found->first == word ? found->second : std::string_view{};
}

std::size_t skip_blanks_from(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of(" \t", at), text.size());
}

}  // namespace

std::string_view form_of_statement(std::string_view text, std::uint32_t at) {
  const std::size_t end = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t line = skip_blanks_from(text, end == std::string_view::npos ? 0 : end + 1);
  const std::string_view first = syntax::word_at(text, line);
  // An edge is told by the word behind its `=`, for it may have any name.
  const std::size_t equals = skip_blanks_from(text, line + first.size());
  const bool edge = !first.empty() && equals < text.size() && text[equals] == '=';
  if (!edge && first == "line") return "line NAME from POINT { ... }";  // inside a piece
  return form_called(edge ? syntax::word_at(text, skip_blanks_from(text, equals + 1)) : first);
}

const std::vector<std::string>& statement_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> made;
    for (const Form& form : forms) {
      if (!form.second.starts_with("NAME = ")) made.emplace_back(form.first);
    }
    return made;
  }();
  return names;
}

}  // namespace toile
