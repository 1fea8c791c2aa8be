// Names, modules, arguments and params: what is unknown, doubled or circular is told where it was written.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Names, UnknownNameSuggestsTheNearest) {
  const Script script("let waist = 68cm\nlet quarter = wiast / 4\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0101 2:15"), HasSubstr("`wiast`"))));
  EXPECT_THAT(script.rendered(), HasSubstr("did you mean `waist`?"));
}

TEST(Names, WhatDependsOnAMistakeIsSilent) {
  const Script script("let a = nowhere\nlet b = a + 1cm\nlet c = sin(b)\nlet d = 1 + 1cm\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0101 1:9"), StartsWith("E0201 4:9")));
}

TEST(Names, DuplicateNamePointsAtBoth) {
  const Script script("let w = 1cm\nparam w = 2cm\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0102 2:7"), HasSubstr("`w`"))));
  EXPECT_THAT(script.rendered(), AllOf(HasSubstr("first defined here"), HasSubstr("defined again here")));
}

TEST(Names, ACircleOfDefinitionsIsShown) {
  const Script script("let a = b + 1\nlet b = c\nlet c = a\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0106 1:5"), HasSubstr("`a` -> `b` -> `c` -> `a`"))));
}

TEST(Names, RecursionWithoutEndIsBounded) {
  const Script script("fn f(n) = f(n + 1) + f(n + 2)\nlet x = f(1)\nlet y = 1cm + 1\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0113 1:"), StartsWith("E0201 3:9")));
}

TEST(Names, FunctionsThatNothingCallsAreChecked) {
  const Script script("fn f(n) {\n  let unused = nn\n  1cm + 2deg + n\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0101 2:16"), StartsWith("E0201 3:3")));
}

TEST(Names, AMistakeInAFunctionShowsTheCall) {
  const Script script("fn add(a, b) = a + b\nlet x = add(1cm, 2)\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0201 1:16")));
  EXPECT_THAT(script.rendered(), HasSubstr("in this call"));
}

TEST(Arguments, UnknownMissingRepeatedAndTooMany) {
  const Script script(
      "fn f(width, depth = 1cm) = width + depth\n"
      "let a = f(1cm, dept: 2cm)\n"
      "let b = f()\n"
      "let c = f(1cm, width: 2cm)\n"
      "let d = f(1cm, 2cm, 3cm)\n"
      "let e = sin(angel: 3deg)\n"
      "let g = f(1cm, depth: 3deg)\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0107 2:16"), HasSubstr("`dept`")),
                                         AllOf(StartsWith("E0108 3:9"), HasSubstr("`width`")), StartsWith("E0109 4:16"),
                                         StartsWith("E0107 5:21"), AllOf(StartsWith("E0107 6:13"), HasSubstr("angel")),
                                         StartsWith("E0203 7:23")));
  EXPECT_THAT(script.rendered(), HasSubstr("did you mean `depth`?"));
}

TEST(Arguments, OnlyFunctionsAreCalled) {
  const Script script("let w = 3cm\nlet x = w(2)\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0210 2:9"), HasSubstr("a length"))));
}

TEST(Modules, UnknownModuleSuggestsTheNearest) {
  const Script script("import bodys\nimport \"cuffs.toile\"\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0104 1:8"), HasSubstr("`bodys`")),
                                         AllOf(StartsWith("E0104 2:8"), HasSubstr("cuffs.toile"))));
  EXPECT_THAT(script.rendered(), HasSubstr("did you mean `bodies`?"));
}

TEST(Modules, UnknownNameInAModule) {
  const Script script("import fabrics as f\nlet x = f.denmi\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0101 2:11"), HasSubstr("fabrics"))));
  EXPECT_THAT(script.rendered(), HasSubstr("did you mean `denim`?"));
}

TEST(Modules, FilesAreImportedUnderTheirStem) {
  Script script("import \"parts/cuffs.toile\"\nprint cuffs.width\n", {}, {{"parts/cuffs.toile", "let width = 7cm\n"}});
  EXPECT_THAT(script.told(), IsEmpty());
  EXPECT_THAT(script.printed(), ElementsAre("7 cm"));
}

TEST(Modules, AnImportCircleShowsItsWay) {
  const Script script("import \"a.toile\"\n", {},
                      {{"a.toile", "import \"b.toile\"\n"}, {"b.toile", "import \"a.toile\"\n"}});
  EXPECT_THAT(script.told(),
              ElementsAre(AllOf(StartsWith("E0105 1:1"), HasSubstr("`a.toile` -> `b.toile` -> `a.toile`"))));
}

TEST(Modules, MistakesInAnImportedFileAreShownThere) {
  const Script script("import \"a.toile\"\n", {}, {{"a.toile", "let x = 1cm + 1deg\n"}});
  EXPECT_THAT(script.rendered(), HasSubstr("a.toile:1:9: error[E0201]"));
}

TEST(Params, SettingsAreExpressions) {
  Script script("param length = 60cm in 30cm..110cm\nprint length\n", {{"length", "2 * 40cm"}});
  EXPECT_THAT(script.printed(), ElementsAre("80 cm"));
}

TEST(Params, OutOfRange) {
  const Script setting("param length = 60cm in 30cm..110cm\n", {{"length", "2m"}});
  EXPECT_THAT(setting.told(),
              ElementsAre(AllOf(StartsWith("E0111 1:1"), HasSubstr("200 cm is not within 30 cm .. 110 cm"))));
  EXPECT_THAT(setting.rendered(), AllOf(HasSubstr("--set length:1:1"), HasSubstr("test.toile:1")));
  const Script fallback("param length = 20cm in 30cm..110cm\n");
  EXPECT_THAT(fallback.told(), ElementsAre(StartsWith("E0111 1:16")));
  const Script inverted("param length = 60cm in 110cm..30cm\n");
  EXPECT_THAT(inverted.told(), ElementsAre(AllOf(StartsWith("E0112 1:"), HasSubstr("110 cm is more than 30 cm"))));
}

TEST(Params, UnknownSettingsSuggestTheNearest) {
  const Script script("param flare = 14cm\n", {{"flair", "20cm"}});
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0110"), HasSubstr("`flair`"))));
  EXPECT_THAT(script.rendered(), HasSubstr("did you mean `flare`?"));
}

TEST(Params, ASettingHasTheDimensionOfItsDefault) {
  EXPECT_THAT(Script("param flare = 14cm\n", {{"flare", "20"}}).told(), ElementsAre(StartsWith("E0201 1:1")));
  EXPECT_THAT(Script("param flare = 14cm\n", {{"flare", "20cm +"}}).told(), ElementsAre(StartsWith("E0001 1:")));
}

TEST(Syntax, SeveralMistakesAndNoNoise) {
  const Script script("lett w = 3cm\nlet half = w / 2\nlet x = (1cm\n\nlet y = 2 furlong\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0001 1:1"), StartsWith("E0002 3:9"),
                                         AllOf(StartsWith("E0204 5:11"), HasSubstr("`furlong` is no unit"))));
}

}  // namespace
}  // namespace toile::test
