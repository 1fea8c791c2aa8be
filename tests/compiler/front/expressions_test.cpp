// What expressions are worth.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Expressions, QuantitiesAreOrdinaryArithmetic) {
  EXPECT_EQ(value_of("(68cm + 2cm) / 4 + 2.5cm"), "20 cm");
  EXPECT_EQ(value_of("3cm * 4cm"), "12 cm^2");
  EXPECT_EQ(value_of("1inch + 1mm"), "2.64 cm");
  EXPECT_EQ(value_of("60cm / 20cm"), "3");
  EXPECT_EQ(value_of("-2^2"), "-4");
  EXPECT_EQ(value_of("2^3^2"), "512");
  EXPECT_EQ(value_of("(3cm)^2"), "9 cm^2");
  EXPECT_EQ(value_of("10 - 4 - 3"), "3");
  EXPECT_EQ(value_of("55% * 20cm"), "11 cm");
  EXPECT_EQ(value_of("3% + 2%"), "5 %");
}

TEST(Expressions, Comparisons) {
  EXPECT_EQ(value_of("1inch > 2.5cm and not 1m < 99cm"), "true");
  EXPECT_EQ(value_of("\"a\" == \"b\" or #fff == #ffffff"), "true");
}

TEST(Expressions, Functions) {
  EXPECT_EQ(value_of("sqrt(9cm * 1cm)"), "3 cm");
  EXPECT_EQ(value_of("sin(30deg)"), "0.5");
  EXPECT_EQ(value_of("atan2(1cm, 1cm)"), "45 deg");
  EXPECT_EQ(value_of("max(1cm, 3cm, 2cm)"), "3 cm");
  EXPECT_EQ(value_of("round(23.46cm, to: 1mm)"), "23.5 cm");
  EXPECT_EQ(value_of("round(2 * pi)"), "6");
  EXPECT_EQ(value_of("sum([1cm, 2cm, 3cm]) / count([1, 2])"), "3 cm");
}

TEST(Expressions, PointsAndCurves) {
  EXPECT_EQ(value_of("(3cm, 4cm) + 2 * (1cm, 0cm)"), "(5 cm, 4 cm)");
  EXPECT_EQ(value_of("((3cm, 4cm)).y"), "4 cm");
  EXPECT_EQ(value_of("distance((0cm, 0cm), (3cm, 4cm))"), "5 cm");
  EXPECT_EQ(value_of("length(arc((1cm, 0cm), (-1cm, 0cm), through: (0cm, 1cm))) / pi"), "1 cm");
  EXPECT_EQ(value_of("point_on(line((0cm, 0cm), (10cm, 0cm)), at: 30%)"), "(3 cm, 0 cm)");
  EXPECT_EQ(value_of("mirror((3cm, 1cm), (0cm, 0cm), (0cm, 5cm))"), "(-3 cm, 1 cm)");
  EXPECT_EQ(value_of("rotate((3cm, 0cm), by: 90deg)"), "(0 cm, 3 cm)");
  EXPECT_EQ(value_of("angle((0cm, 0cm), (1cm, 1cm))"), "45 deg");
  EXPECT_EQ(value_of("length(part(line((0cm, 0cm), (10cm, 0cm)), from: 2cm, to: 50%))"), "3 cm");
}

TEST(Expressions, ListsCountFromOne) {
  EXPECT_EQ(value_of("[i * 2cm for i in 1..4]"), "[2 cm, 4 cm, 6 cm, 8 cm]");
  EXPECT_EQ(value_of("[10, 20, 30][2]"), "20");
  EXPECT_EQ(value_of("[x + 1 for x in [1, 2]]"), "[2, 3]");
  EXPECT_EQ(value_of("[i for i in 2..1]"), "[]");
}

TEST(Expressions, DefinitionsStandInAnyOrder) {
  EXPECT_EQ(value_of("a", "let a = b / 2\nlet b = 10cm"), "5 cm");
}

TEST(Expressions, FunctionsHaveDefaultsAndNamedArguments) {
  const std::string before =
      "fn seam(width = 1cm, times = 2) = width * times\n"
      "fn hypotenuse(a, b) {\n  let square = a^2 + b^2\n  sqrt(square)\n}";
  EXPECT_EQ(value_of("seam()", before), "2 cm");
  EXPECT_EQ(value_of("seam(times: 3)", before), "3 cm");
  EXPECT_EQ(value_of("hypotenuse(3cm, 4cm)", before), "5 cm");
  EXPECT_EQ(value_of("hypotenuse(3, b: 4)", before), "5");
}

TEST(Expressions, RecursionThatEnds) {
  EXPECT_EQ(value_of("factorial(10)", "fn factorial(n) = if n <= 1 then 1 else n * factorial(n - 1)"), "3.6288e+06");
}

TEST(Expressions, ABranchThatIsNotTakenIsCheckedButNotComputed) {
  EXPECT_EQ(value_of("if n == 0 then 0 else 1 / n", "let n = 0"), "0");
  EXPECT_EQ(value_of("f(0)", "fn f(n) {\n  let inverse = 1 / n\n  if n == 0 then 0 else inverse\n}"), "0");
  EXPECT_THAT(value_of("if true then 1cm else 1cm + 3deg"), HasSubstr("E0201"));
  EXPECT_THAT(value_of("true or 1cm < 3deg"), HasSubstr("E0201"));
}

TEST(Expressions, AFunctionIsFoundBehindAMeasureOfItsName) {
  EXPECT_EQ(value_of("length(line((0cm, 0cm), (0cm, length)))", "param length = 60cm"), "60 cm");
}

TEST(Expressions, BodiesTellTheirLines) {
  const std::string before = "import bodies\nbody form = bodies.dress_form(waist: 70cm)";
  EXPECT_EQ(value_of("form.waist.girth", before), "70 cm");
  EXPECT_EQ(value_of("form.waist.level > form.hip.level", before), "true");
}

TEST(Expressions, TextAndColoursPrintAsTheyAre) {
  EXPECT_EQ(value_of("\"hem\", 3cm, #1f3a5f"), "hem 3 cm #1f3a5f");
}

}  // namespace
}  // namespace toile::test
