// Measurements of bodies by their names in ISO 8559-1 and elsewhere, and figures that cannot be.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Measurements, ArgumentsHaveTheNamesOfIsoAndOfOtherPrograms) {
  const auto girths = [](const std::string& arguments) {
    return value_of("f.waist.girth, f.hip.girth, f.bust.girth",
                    "import bodies\nbody f = bodies.dress_form(" + arguments + ")");
  };
  EXPECT_EQ(girths("waist: 70cm, hip: 96cm, bust: 90cm"), "70 cm 96 cm 90 cm");
  EXPECT_EQ(girths("waist_girth: 70cm, hip_girth: 96cm, bust_girth: 90cm"), "70 cm 96 cm 90 cm");
  EXPECT_EQ(girths("waist: 70cm, seat: 96cm, chest: 90cm"), "70 cm 96 cm 90 cm");
  EXPECT_EQ(girths("waist_circ: 70cm, hip_circ: 96cm, bust_circ: 90cm"), "70 cm 96 cm 90 cm");
}

TEST(Measurements, TablesAndRecordsAreReadByAnyOfTheNames) {
  const std::string table = "sizes t(waist_girth, seat) {\n  M 70cm, 96cm\n}";
  EXPECT_EQ(value_of("t.waist, t.waist_girth, t.hip, t.waist_circ", table), "70 cm 70 cm 96 cm 70 cm");
  EXPECT_EQ(value_of("f.waist.girth, f.hip.girth", "import bodies\n" + table + "\nbody f = bodies.dress_form(t...)"),
            "70 cm 96 cm");
}

TEST(Measurements, OneOfThemIsNotGivenTwice) {
  const Script script("import bodies\nbody f = bodies.dress_form(waist: 70cm, waist_girth: 71cm)\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0109 2:41 `waist_girth` is given twice")));
}

TEST(Measurements, HipsMeansTwoThings) {
  const Script script("import bodies\nbody f = bodies.dress_form(hips: 96cm)\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0107 2:28")));
  EXPECT_THAT(script.rendered(), HasSubstr("write `hip` or `top_hip`"));
}

TEST(Measurements, AFigureThatContradictsItselfIsAskedAbout) {
  const Script sizes("sizes t(hip, waist) {\n  S 90cm, 64cm\n  M 68cm, 94cm\n}\nprint t.waist\n");
  EXPECT_THAT(sizes.told(), ElementsAre("W0410 3:11 size `M` has `waist` 94 cm and `hip` 68 cm"));
  EXPECT_TRUE(sizes.program->ok());
  const Script body("import bodies\nbody f = bodies.dress_form(waist: 99cm)\n");
  EXPECT_THAT(body.told(), ElementsAre("W0410 2:35 body `dress_form` has `waist` 99 cm and `hip` 94 cm"));
}

TEST(Measurements, OfDefaultsNothingIsAsked) {
  const std::string doll =
      "body doll(waist = 12cm, hip = waist - 1cm, height = 30cm) {\n  section a at 10cm { girth hip }\n"
      "  section b at 20cm { girth waist }\n}\n";
  EXPECT_THAT(Script(doll + "body d = doll()\n").told(), IsEmpty());
  EXPECT_THAT(Script(doll + "body d = doll(hip: 11cm)\n").told(),
              ElementsAre(StartsWith("W0411 5:20 body `doll` has `hip` 11 cm")));
}

TEST(Measurements, SoIsOneThatNobodyHas) {
  const Script script("sizes t(waist, stature) {\n  M 680cm, 16.5cm\n}\nprint t.waist\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0403 2:5 size `M` cannot have `waist` 680 cm"),
                                         StartsWith("W0411 2:12 size `M` has `stature` 16.5 cm")));
  EXPECT_THAT(Script("sizes t(width, length) {\n  M 680cm, 1mm\n}\nprint t.width\n").told(), IsEmpty());
}

}  // namespace
}  // namespace toile::test
