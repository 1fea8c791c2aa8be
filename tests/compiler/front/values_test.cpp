// Records, texts with values in them, filtered lists, params with choices.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Records, FieldsAreReadByName) {
  EXPECT_EQ(value_of("m", "let m = (waist: 68cm, name: \"S\")"), "(waist: 68 cm, name: S)");
  EXPECT_EQ(value_of("m.waist / 4, m.name", "let m = (waist: 68cm, name: \"S\")"), "17 cm S");
  EXPECT_EQ(value_of("m.at.x", "let m = (\n  at: (3cm, 4cm),\n  n: 1,\n)"), "3 cm");
}

TEST(Records, InListsAndFunctions) {
  const std::string table =
      "let sizes = [(name: \"S\", waist: 68cm), (name: \"M\", waist: 72cm)]\n"
      "fn quarter(m) = m.waist / 4\n"
      "fn sized(w) = (waist: w, hip: w + 26cm)\n";
  EXPECT_EQ(value_of("[quarter(m) for m in sizes], sized(70cm).hip", table), "[17 cm, 18 cm] 96 cm");
}

TEST(Records, MistakesAreTold) {
  const Script script(
      "let m = (waist: 68cm, waist: 70cm)\nlet a = m.wiast\nlet b = [(x: 1), (y: 1)]\nlet c = (x: 1cm) + 2cm\n");
  EXPECT_THAT(script.told(),
              ElementsAre(AllOf(StartsWith("E0102 1:23"), HasSubstr("`waist`")), StartsWith("E0103 2:11"),
                          AllOf(StartsWith("E0202 3:10"), HasSubstr("a record (x) and a record (y)")),
                          StartsWith("E0202 4:9")));
  EXPECT_THAT(script.rendered(), HasSubstr("did you mean `waist`?"));
}

TEST(Records, TakeOverWhatTheyDoNotSayThemselves) {
  const std::string m = "let m = (waist: 68cm, hip: 94cm)\n";
  EXPECT_EQ(value_of("(waist: 70cm, m...)", m), "(waist: 70 cm, hip: 94 cm)");
  EXPECT_EQ(value_of("(length: 60cm, m..., (bust: 90cm, hip: 0cm)...)", m),
            "(length: 60 cm, waist: 68 cm, hip: 94 cm, bust: 90 cm)");
  EXPECT_EQ(value_of("m.hip", m + "let n = (waist: 1cm, m...)"), "94 cm");
}

TEST(Records, AndListsAreComparedPartByPart) {
  const std::string m = "let m = (waist: 68cm, hip: 94cm)\n";
  EXPECT_EQ(value_of("m == (hip: 94cm, waist: 68cm), m == (waist: 68cm, hip: 95cm), m != (waist: 1cm, m...)", m),
            "true false true");
  EXPECT_EQ(value_of("[1cm, 2cm] == [1cm, 2cm], [1cm] == [1cm, 2cm], [[1]] != [[2]], [] == [3cm]"),
            "true false true false");
}

TEST(Records, ThatCannotBeComparedOrTakenOverAreTold) {
  const Script script(
      "let m = (waist: 68cm)\nlet a = m == (hip: 68cm)\nlet b = [1cm] == [1deg]\nlet c = (x: 1, 3cm...)\nlet d = m == "
      "3\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0202 2:9"), StartsWith("E0202 3:9"), StartsWith("E0202 4:16"),
                                         StartsWith("E0202 5:9")));
}

TEST(Texts, HoldValuesWithTheirUnits) {
  const std::string w = "let w = 23.4cm\nlet n = 2\n";
  EXPECT_EQ(value_of("\"cut {n} of {w}\"", w), "cut 2 of 23.4 cm");
  EXPECT_EQ(value_of("\"{w in mm}, {w + 2cm in inch}; {n / 8 in %}\"", w), "234 mm, 10 inch; 25 %");
  EXPECT_EQ(value_of("\"\\{n} is {n} } {[1cm, 2cm]}\"", w), "{n} is 2 } [1 cm, 2 cm]");
  EXPECT_EQ(value_of("\"{if n > 1 then \"many\" else \"one\"}\"", w), "many");
}

TEST(Texts, MistakesInThemAreToldAtTheirPlaces) {
  const Script script("let w = 3cm\nprint \"{wd} {w in deg}\"\nprint \"{w in ells}\"\nprint \"{w\"\n");
  EXPECT_THAT(script.told(),
              ElementsAre(StartsWith("E0101 2:9"), AllOf(StartsWith("E0201 2:14"), HasSubstr("a length")),
                          AllOf(StartsWith("E0204 3:14"), HasSubstr("`ells` is no unit")), StartsWith("E0001 4:10")));
}

TEST(Texts, ResultsOfADrapeAreShownOnceTheyAreThere) {
  Script script(
      "import fabrics\ngarment g in fabrics.silk {\n  piece p {\n    outline from (0cm, 0cm) {\n"
      "      a = line to (9cm, 0cm)\n      b = line to (9cm, 9cm)\n      c = line to start\n    }\n  }\n}\n"
      "drape g as worn\nprint \"{worn.contact.weight in gf} and {worn.folds} folds\"\n");
  EXPECT_THAT(script.told(), IsEmpty());
  EXPECT_THAT(script.printed({{"contact.weight", 9.80665e-3}, {"folds", 5}}), ElementsAre("1 gf and 5 folds"));
}

TEST(Lists, MayLeaveElementsOut) {
  EXPECT_EQ(value_of("[i for i in 1..9 if i / 3 == round(i / 3)]"), "[3, 6, 9]");
  EXPECT_THAT(value_of("[i for i in 1..3 if i]"), HasSubstr("E0202"));
}

TEST(Choices, AParamTakesOneOfThem) {
  const std::string text = "param collar = \"stand\" in [\"stand\", \"shirt\", \"none\"]\nprint collar\n";
  Script script(text, {{"collar", "\"shirt\""}});
  EXPECT_THAT(script.told(), IsEmpty());
  EXPECT_THAT(script.printed(), ElementsAre("shirt"));
  const Script wrong(text, {{"collar", "\"shrit\""}});
  EXPECT_THAT(wrong.told(), ElementsAre(AllOf(StartsWith("E0117"), HasSubstr("stand, shirt, none"))));
  EXPECT_THAT(wrong.rendered(), HasSubstr("did you mean `shirt`?"));
  EXPECT_THAT(Script("param pleats = 5 in [2, 4, 6]\n").told(), ElementsAre(StartsWith("E0117 1:16")));
}

}  // namespace
}  // namespace toile::test
