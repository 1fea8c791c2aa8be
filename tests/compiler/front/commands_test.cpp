// Commands: checked before anything runs, evaluated one by one with the results of those before.
#include <gmock/gmock.h>

#include <set>

#include "compiler/units/unit.hpp"
#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string skirt =
    "import bodies\nimport fabrics\nbody form = bodies.dress_form()\nbody ball = sphere(radius: 10cm)\n"
    "garment skirt in fabrics.silk {\n  piece p {\n    outline from (0cm, 0cm) {\n      top = line to (80cm, 0cm)\n"
    "      side = line to (80cm, -40cm)\n      hem = line to (0cm, -40cm)\n      back = line to start\n    }\n  }\n"
    "  sew p.side to p.back\n  wear p.top at form.waist\n}\n";  // 16 lines

TEST(Commands, ResultsAreUsedByLaterLines) {
  Script script(skirt +
                "drape skirt on form as worn to 1e-6\n"
                "let height = worn.bounds.high - worn.bounds.low\n"
                "print \"height\", height, \"weight\", worn.contact.weight\n"
                "expect worn.contact.weight_error < 0.1% and worn.folds >= 5\n"
                "render worn to \"pictures/./front.png\" from front showing strain.warp pixels 400, 300\n"
                "export worn to \"skirt.glb\"\nexport skirt to \"skirt.svg\"\n");
  ASSERT_THAT(script.told(), IsEmpty()) << script.rendered();
  const auto drape = script.program->next();
  ASSERT_TRUE(drape && std::holds_alternative<DrapeCommand>(*drape));
  EXPECT_EQ(std::get<DrapeCommand>(*drape).name, "worn");
  EXPECT_EQ(*std::get<DrapeCommand>(*drape).accuracy, 1e-6);
  EXPECT_EQ(script.program->bodies().at(std::get<DrapeCommand>(*drape).body).name, "form");
  script.program->give({{"bounds.high", 1.0},
                        {"bounds.low", 0.6},
                        {"contact.weight", 2.5},
                        {"contact.weight_error", 0.0005},
                        {"folds", 4}});
  EXPECT_EQ(std::get<PrintCommand>(*script.program->next()).text, "height 40 cm weight 2.5 N");
  const auto expect = std::get<ExpectCommand>(*script.program->next());
  EXPECT_FALSE(expect.holds);
  EXPECT_EQ(expect.text, "worn.contact.weight_error < 0.1% and worn.folds >= 5");
  EXPECT_EQ(expect.found, "worn.contact.weight_error is 0.05 %; worn.folds is 4");
  const auto render = std::get<RenderCommand>(*script.program->next());
  EXPECT_EQ(render.path, "pictures/front.png");
  EXPECT_EQ(render.view, "front");
  EXPECT_EQ(render.field, "strain.warp");
  EXPECT_EQ(render.width, 400);
  EXPECT_EQ(std::get<ExportCommand>(*script.program->next()).result, "worn");
  EXPECT_EQ(std::get<ExportCommand>(*script.program->next()).garment, 0);
  EXPECT_FALSE(script.program->next());
}

TEST(Commands, ResultsAreCheckedBeforeTheDrape) {
  const Script script(skirt +
                      "drape skirt on form as worn\n"
                      "expect worn.contact.weight_error < 3cm\n"
                      "expect worn.contact.wieght > 1N\n"
                      "expect worn.folds\n"
                      "print worn.energy.total + worn.contact.weight\n");
  EXPECT_THAT(script.told(),
              ElementsAre(AllOf(StartsWith("E0201 18:8"), HasSubstr("a plain number and a length")),
                          AllOf(StartsWith("E0103 19:21"), HasSubstr("`worn.contact` has no field `wieght`")),
                          StartsWith("E0202 20:8"), StartsWith("E0201 21:7")));
  EXPECT_THAT(script.rendered(), HasSubstr("did you mean `weight`?"));
}

TEST(Commands, UseBeforeTheDrape) {
  const Script script(
      skirt + "print worn.folds\nrender worn to \"a.png\"\ndrape skirt on form as worn\nrender skirt to \"b.png\"\n");
  EXPECT_THAT(script.told(),
              ElementsAre(StartsWith("E0506 17:12"), StartsWith("E0506 18:8"), StartsWith("E0506 20:8")));
}

TEST(Commands, OutputsStayInTheirFolder) {
  const Script script(skirt +
                      "drape skirt on form as worn\n"
                      "render worn to \"../a.png\"\n"
                      "render worn to \"/tmp/a.png\"\n"
                      "export worn to \"a/../../b.obj\"\n"
                      "render worn to \"a.jpg\"\n"
                      "export skirt to \"a.glb\"\n"
                      "export worn to \"b.obj\"\n"
                      "export worn to \"./b.obj\"\n"
                      "render worn to 3cm\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0501 18:16"), StartsWith("E0501 19:16"),
                                         StartsWith("E0501 20:16"), AllOf(StartsWith("E0503 21:16"), HasSubstr(".png")),
                                         AllOf(StartsWith("E0503 22:17"), HasSubstr(".svg, .dxf or .json")),
                                         StartsWith("E0502 24:16"), StartsWith("E0201 25:16")));
}

TEST(Commands, ViewsAndFields) {
  const Script script(skirt +
                      "drape skirt on form as worn\nrender worn to \"a.png\" from frnt\nrender worn to \"b.png\" "
                      "showing strain.wrap\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0504 18:29"), HasSubstr("`frnt`")),
                                         AllOf(StartsWith("E0504 19:32"), HasSubstr("`strain.wrap`"))));
}

TEST(Commands, TheBodyIsTheOneThatIsWorn) {
  const Script script(skirt + "drape skirt on ball as worn\ndrape skirt as floating\ndrape form on form\n");
  EXPECT_THAT(script.told(),
              ElementsAre(AllOf(StartsWith("E0505 17:1"), HasSubstr("worn at `form.waist`, but draped on `ball`")),
                          AllOf(StartsWith("E0505 18:1"), HasSubstr("no body")), StartsWith("E0202 19:7")));
}

TEST(Commands, AGarmentOfNothingIsNotDraped) {
  const Script script(
      "garment g {\n  piece p {\n    outline from (0cm, 0cm) {\n      a = line to (1cm, 0cm)\n      b = line to (1cm, "
      "1cm)\n"
      "      c = line to start\n    }\n  }\n}\ndrape g\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0409 10:7"), HasSubstr("what it is made of"))));
}

TEST(Commands, APatternCannotDependOnADrape) {
  const Script script(
      skirt +
      "drape skirt on form as worn\n"
      "garment g {\n  piece p {\n    outline from (0cm, 0cm) {\n      a = line to (worn.hem.length, 0cm)\n"
      "      b = line to (1cm, 1cm)\n      c = line to start\n    }\n  }\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0506 21:19")));
}

TEST(Commands, ThereAreNoneAfterAnError) {
  Script script("print 1\nprint 1 + 1cm\n");
  EXPECT_FALSE(script.program->ok());
  EXPECT_FALSE(script.program->next());
}

TEST(Commands, TheSchemaNamesEachFieldOnceWithAUnit) {
  std::set<std::string> seen;
  for (const auto& [name, unit] : result_schema()) {
    EXPECT_TRUE(seen.insert(name).second) << name;
    EXPECT_TRUE(unit == "1" || parse_unit(unit)) << unit;
    for (const auto& [other, ignored] : result_schema()) EXPECT_FALSE(other.starts_with(name + ".")) << other;
  }
}

}  // namespace
}  // namespace toile::test
