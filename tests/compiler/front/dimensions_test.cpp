// Dimensions and magnitudes: quantities that do not go together, and values that are none.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Dimensions, BothOperandsAreUnderlined) {
  const Script script("let girth = 68cm + 3deg\n");
  EXPECT_EQ(script.rendered(),
            "test.toile:1:13: error[E0201]: a length and an angle cannot be added\n"
            "  |\n"
            "1 | let girth = 68cm + 3deg\n"
            "  |             ^^^^   ^^^^ an angle\n"
            "  |             |\n"
            "  |             a length\n");
}

TEST(Dimensions, AForgottenUnitIsGuessed) {
  const Script script("let w = 68cm + 2\nlet s = sin(2)\nlet p = (1cm, 0)\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0201 1:9"), StartsWith("E0203 2:13"), StartsWith("E0201 3:10")));
  EXPECT_THAT(script.rendered(), AllOf(HasSubstr("`2cm`, not `2`"), HasSubstr("every angle has its unit")));
}

TEST(Dimensions, WrongKinds) {
  const Script script(
      "let c = line((0cm, 0cm), (1cm, 0cm))\n"
      "let a = c + 1cm\n"
      "let b = length(3cm)\n"
      "let d = if 3cm then 1 else 2\n"
      "let e = if true then 1 else 2cm\n"
      "let f = [1cm, 2deg]\n"
      "let g = (3cm)^0.5\n"
      "let h = sqrt(3cm)\n"
      "let i = c.middle\n");
  EXPECT_THAT(script.told(),
              ElementsAre(StartsWith("E0202 2:9"), StartsWith("E0203 3:16"), StartsWith("E0202 4:12"),
                          StartsWith("E0202 5:22"), StartsWith("E0202 6:10"), StartsWith("E0205 7:"),
                          StartsWith("E0205 8:14"), AllOf(StartsWith("E0103 9:11"), HasSubstr("`middle`"))));
}

TEST(Values, NoNumberAndAbsurdLengths) {
  const Script script(
      "let zero = 0\n"
      "let a = 3cm / zero\n"
      "let b = sqrt(-2)\n"
      "let c = 10^400\n"
      "let d = 60m * 2\n"
      "let e = (1cm, 200m)\n"
      "let f = asin(2)\n"
      "let g = [1, 2][3]\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0206 2:15"), StartsWith("E0206 3:14"), StartsWith("E0206 4:9"),
                                         AllOf(StartsWith("E0207 5:9"), HasSubstr("120 m")), StartsWith("E0207 6:15"),
                                         StartsWith("E0206 7:14"), StartsWith("E0209 8:16")));
}

TEST(Values, ListsAndStepsAreBounded) {
  EXPECT_THAT(Script("let a = [i for i in 1..1000000000]\n").told(), ElementsAre(StartsWith("E0113 1:")));
  EXPECT_THAT(Script("let a = [i for i in 10^17..10^17 + 20]\n").told(), IsEmpty());  // no step is seen out there
  const std::string ten =
      "[[[[[[[i for a in 1..99] for b in 1..99] for c in 1..99] for d in 1..99] for e in 1..99] for "
      "f in 1..99] for i in 1..99]";
  EXPECT_THAT(Script("let a = " + ten + "\n").told(), ElementsAre(StartsWith("E0113 1:")));
}

TEST(Values, AVeryLongSumIsAMistakeAndNoCrash) {
  std::string text = "let a = 1";
  for (int i = 0; i < 50000; ++i) text += " + 1";
  EXPECT_LE(Script(text + "\n").told().size(), 1u);
}

}  // namespace
}  // namespace toile::test
