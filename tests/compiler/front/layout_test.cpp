// A script that is laid out anew makes the same pattern, to the last digit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fmt/format.h>

#include "grammar/format/format.hpp"
#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

int any(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}

/// Blanks as careless people leave them.
std::string blanks() {
  return std::string(static_cast<std::size_t>(any(1, 3)), ' ');
}

std::string any_garment() {
  std::string text = fmt::format("let w{}={}cm\ngarment g{{\n", blanks(), any(20, 40));
  const int height = any(20, 60);
  for (const char* name : {"front", "back"}) {
    text += fmt::format("piece{}{}{{\noutline from (0cm,0cm){{\n", blanks(), name);
    text += fmt::format("hem = curve to (w,{}mm){}leaving {}deg\n", any(-20, 20), blanks(), any(-20, 20));
    text += fmt::format("side{}= line to (w,{}cm)\ntop=arc to (0cm , {}cm) radius {}cm\n", blanks(), height, height,
                        any(60, 90));
    text += fmt::format("centre = line{}to start }}\n", blanks());
    if (any(0, 1) == 0) text += fmt::format("fold{}centre\n", blanks());
    for (int i = 0; i < any(0, 2); ++i) {
      text += fmt::format("dart at {}% of hem{{width {}mm,depth {}cm}}\n", 20 + 40 * i, any(10, 30), any(4, 9));
    }
    text +=
        fmt::format("notch at{}{}cm of side // here\nallowance 1cm,hem {}cm\n}}\n", blanks(), any(2, 18), any(1, 4));
  }
  return text + "sew front.side to back.side ease notch at 50%\n}\n";
}

RC_GTEST_PROP(Layout, ChangesNoPattern, ()) {
  const std::string text = any_garment();
  const Source source("test.toile", text);
  const Script careless(text), tidy(syntax::format(syntax::parse(source), source));
  RC_CLASSIFY(careless.program->ok(), "sound");
  RC_ASSERT(careless.program->diagnostics().size() == tidy.program->diagnostics().size());
  RC_ASSERT(emit_pattern(*careless.program) == emit_pattern(*tidy.program));
}

}  // namespace
}  // namespace toile::test
