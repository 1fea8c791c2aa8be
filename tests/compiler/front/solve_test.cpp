// `solve`: values that make equations hold, in every kind of block, and what is said where there are none.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Solve, OneUnknownWithinItsRange) {
  EXPECT_EQ(value_of("r", "solve r in 1cm..1m so 2 * pi * r = 68cm"), "10.8225 cm");
  EXPECT_EQ(value_of("x", "solve x in 0..2 so x^2 = 2"), "1.41421");
  EXPECT_EQ(value_of("a", "solve a in 0deg..90deg so sin(a) = 50%"), "30 deg");
}

TEST(Solve, ACapForAnArmhole) {
  const std::string script =
      "let armhole = 44cm\n"
      "fn cap(h) = curve((0cm, 0cm), (32cm, 0cm), leaving: atan(h / 16cm) * 1.4, arriving: -atan(h / 16cm) * 1.4)\n"
      "solve h in 8cm..30cm so length(cap(h)) = armhole + 2cm\n";
  EXPECT_EQ(value_of("round(length(cap(h)), to: 1um)", script), "46 cm");
}

TEST(Solve, StandsOverSeveralLines) {
  EXPECT_EQ(value_of("x + y", "solve x in 0cm..9cm,\n      y in 0cm..9cm\n  so x - y = 1cm,\n     x + y = 5cm"),
            "5 cm");
}

TEST(Solve, DefinitionsMayDependOnTheUnknown) {
  EXPECT_EQ(value_of("area", "let area = side^2\nsolve side in 1cm..1m so area = 25cm^2"), "25 cm^2");
  const std::string piece =
      "garment g {\n  piece sleeve {\n    solve rise in 2cm..30cm so length(cap) = 44cm\n"
      "    outline from (0cm, 0cm) {\n      cap = arc to (32cm, 0cm) through (16cm, rise)\n"
      "      under = line to start\n    }\n  }\n}\n";
  EXPECT_EQ(value_of("length(g.sleeve.cap), round(g.sleeve.rise, to: 1mm)", piece), "44 cm 12.6 cm");
}

TEST(Solve, LooksIntoGarmentsAndMakesThemOnce) {
  Script script(
      "garment strip(w) {\n  piece p {\n    outline from (0cm, 0cm) {\n      a = line to (w, 0cm)\n"
      "      b = line to (0cm, 3cm)\n      c = line to start\n    }\n  }\n}\n"
      "solve w in 1cm..9cm so length(strip(w).p.b) = 5cm\nlet made = strip(w)\nprint length(made.p.a)\n");
  EXPECT_THAT(script.told(), IsEmpty());
  EXPECT_THAT(script.printed(), ElementsAre("4 cm"));
  EXPECT_EQ(script.program->garments().size(), 1u);
}

TEST(Solve, InFunctionsAndWithinEachOther) {
  const std::string root = "fn root(a) {\n  solve x in 0..100 so square = a\n  let square = x * x\n  x\n}\n";
  EXPECT_EQ(value_of("root(9), root(16)", root), "3 4");
  EXPECT_EQ(value_of("y", root + "solve y in 0..100 so root(y) = 5"), "25");
}

TEST(Solve, SeveralUnknowns) {
  EXPECT_EQ(value_of("x, y", "solve x in 0cm..9cm, y in 0cm..9cm so x * y = 12cm^2, x - y = 1cm"), "4 cm 3 cm");
  const std::string two_bars =
      "solve a in 0deg..90deg, b in -90deg..0deg\n"
      "  so polar(10cm, a) + polar(10cm, b) = (10cm, 0cm)";
  EXPECT_EQ(value_of("a, b", two_bars), "60 deg -60 deg");
}

TEST(Solve, WithoutAChangeOfSignShowsBothEnds) {
  const Script script("let c = 20cm\nsolve h in 8cm..12cm so 2 * h + 1cm = c + 10cm\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0114 2:25"), HasSubstr("no `h` within 8 cm .. 12 cm"))));
  EXPECT_THAT(script.rendered(),
              AllOf(HasSubstr("17 cm at h = 8 cm, 25 cm at h = 12 cm"), HasSubstr("30 cm at both ends"),
                    HasSubstr("they come nearest at h = 12 cm, 5 cm apart: widen the range there")));
}

TEST(Solve, AnEquationWithoutTheUnknownIsNoticed) {
  const Script script("let c = 20cm\nsolve h in 8cm..12cm so 2 * c = 30cm\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0114 2:25")));
  EXPECT_THAT(script.rendered(), HasSubstr("neither side changes with `h`"));
}

TEST(Solve, SeveralSolutionsAreToldApart) {
  const Script script("solve x in -2..2 so x^2 = 1\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0114 1:21"), HasSubstr("more than one `x`"))));
  EXPECT_THAT(script.rendered(), HasSubstr("near -1"));
}

TEST(Solve, AJumpIsNoSolution) {
  const Script script("solve x in 0..1 so (if x < 0.3 then 1 else 3) = 2\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0114"), HasSubstr("jump past each other at x = 0.3"))));
}

TEST(Solve, PartsOfTheRangeMayHaveNoValue) {
  EXPECT_EQ(value_of("x", "solve x in -1..9 so sqrt(x) = 2"), "4");
}

TEST(Solve, AMistakeAtEveryValueIsShownAtOne) {
  const Script script("solve x in 1..2 so sqrt(-x) = 2\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0206 1:25"), HasSubstr("negative"))));
  EXPECT_THAT(script.rendered(), HasSubstr("while trying x = 1"));
}

TEST(Solve, SidesThatCanNeverBeEqual) {
  const Script script("solve x in 1cm..2cm so 2 * x = 3deg\nsolve y in 0..1 so y = (1cm, 2cm)\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0201 1:24"), HasSubstr("a length and an angle")),
                                         StartsWith("E0201 2:20")));
}

TEST(Solve, EquationsThatContradictShowHowNearTheyCome) {
  const Script script("solve a in 0cm..9cm, b in 0cm..9cm so a + b = 4cm, a + b = 6cm\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0115 1:39")));
  EXPECT_THAT(script.rendered(), AllOf(HasSubstr("at best 5"), HasSubstr("they come nearest at a = ")));
}

TEST(Solve, EachUnknownNeedsAnEquation) {
  const Script script("solve a in 0cm..9cm, b in 0cm..9cm so a + b = 4cm\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0116 1:1")));
}

TEST(Solve, RangesAreChecked) {
  const Script script("solve a in 9cm..1cm so a = 2cm\nsolve b in 1cm..2deg so b = 1cm\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0112 1:"), StartsWith("E0201 2:")));
}

TEST(Solve, MistakesElsewhereAreStillFound) {
  const Script script("let bad = 1cm + 1deg\nlet good = if false then bad else 2cm\nsolve a in 0cm..9cm so a = good\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0201 1:11")));
}

TEST(Solve, InAFunctionThatNothingCallsIsChecked) {
  const Script script("fn f(a) {\n  solve x in 0cm..9cm so x = 3deg\n  x + a\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0201 2:26")));
}

TEST(Solve, AVariationMayReplaceWhatItsModelSolved) {
  const std::string pieces =
      "garment g {\n  piece a {\n    solve w in 1cm..9cm so length(x) = 5cm\n    outline from (0cm, 0cm) {\n"
      "      x = line to (w, 3cm)\n      y = line to (0cm, 6cm)\n      z = line to start\n    }\n  }\n"
      "  piece b = a with {\n    let w = 2cm\n  }\n"
      "  piece c = a with {\n    outline {\n      x = line to (2 * w, 3cm)\n    }\n  }\n"
      "  sew a.z to b.z\n  sew a.y to c.y\n}\n";
  EXPECT_EQ(value_of("g.a.w, g.b.w, g.c.w", pieces), "4 cm 2 cm 2 cm");
}

TEST(Solve, SurvivesAFirstUnknownWhoseNameIsTaken) {
  const Script script("let a = 1cm\nsolve a in 1cm..2cm, b in 1cm..2cm so a = 1cm, b = 1cm\nprint b\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0102 2:7")));
}

}  // namespace
}  // namespace toile::test
