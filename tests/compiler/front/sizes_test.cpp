// Size tables: which size is chosen, what its measures are, and what is wrong with a table.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string women =
    "sizes women(waist, hip, height = 2 * waist) at M {\n  S 64cm, 90cm\n  M 68cm, 94cm\n  38 70cm, 96cm, 170cm\n}\n";

/// A script in a size.
struct Sized : Script {
  Sized(const std::string& text, const std::string& size, const std::vector<Setting>& settings = {},
        std::map<std::string, std::string> files = {})
      : Script("") {
    world.files = std::move(files);
    program = load("test.toile", text, settings, world, size);
  }
};

TEST(Sizes, TheTableStandsForTheChosenSize) {
  const std::string text = women + "print women.size, women.waist, women.hip, women.height\n";
  EXPECT_THAT(Sized(text, "S").printed(), ElementsAre("S 64 cm 90 cm 128 cm"));
  EXPECT_THAT(Sized(text, "38").printed(), ElementsAre("38 70 cm 96 cm 170 cm"));
}

TEST(Sizes, WithoutAChoiceItIsTheOneAfterAtOrTheFirst) {
  EXPECT_EQ(value_of("women.size", women), "M");
  EXPECT_EQ(value_of("men.size", "sizes men(chest) {\n  48 96cm\n  50 100cm\n}"), "48");
}

TEST(Sizes, AllOfThemAreAList) {
  EXPECT_EQ(value_of("[s.size for s in women.all if s.waist > 65cm]", women), "[M, 38]");
}

TEST(Sizes, ParamsTakeTheirDefaultsFromATableAndSettingsComeBeforeIt) {
  const std::string text = women + "param waist = women.waist in 60cm..69cm\nprint waist\n";
  EXPECT_THAT(Sized(text, "S").printed(), ElementsAre("64 cm"));
  EXPECT_THAT(Sized(text, "S", {{"waist", "66cm"}}).printed(), ElementsAre("66 cm"));
  EXPECT_THAT(Sized(text, "38").told(), ElementsAre(StartsWith("E0111 6:15 the default of `waist` is out of range")));
}

TEST(Sizes, BodiesAreMadeToMeasure) {
  const std::string text = "import bodies\n" + women +
                           "body form = bodies.dress_form(waist: women.waist, hip: women.hip)\nprint form.hip.girth\n";
  EXPECT_THAT(Sized(text, "S").printed(), ElementsAre("90 cm"));
}

TEST(Sizes, TablesOfImportedFilesFollowTheSameChoice) {
  const std::string text = "import \"measures.toile\"\nprint measures.women.waist\n";
  EXPECT_THAT(Sized(text, "S", {}, {{"measures.toile", women}}).printed(), ElementsAre("64 cm"));
  EXPECT_THAT(Sized(text, "", {}, {{"measures.toile", women}}).program->sizes(), ElementsAre("S", "M", "38"));
}

TEST(Sizes, OnlySizesOfEveryTableCanBeChosen) {
  const std::string men = "sizes men(chest) {\n  M 96cm\n  L 102cm\n}\n";
  EXPECT_THAT(Script(women + men).program->sizes(), ElementsAre("M"));
  EXPECT_THAT(Sized(women + men, "S").told(), ElementsAre(StartsWith("E0118 6:7 `men` has no size `S`")));
}

TEST(Sizes, AnUnknownSizeIsToldWithTheNearestAndAll) {
  const Sized script(women + "print women.waist + 3cm\n", "39");
  EXPECT_THAT(script.told(), ElementsAre("E0118 1:7 `women` has no size `39`"));
  EXPECT_THAT(script.rendered(), AllOf(HasSubstr("its sizes are S, M, 38"), HasSubstr("did you mean `38`?")));
  EXPECT_THAT(Sized("let a = 3\n", "M").told(), ElementsAre("E0118 1:1 this script has no size table, so no size `M`"));
  EXPECT_THAT(Script("sizes a(b) at L {\n  M 1\n}\n").told(), ElementsAre("E0118 1:15 `a` has no size `L`"));
}

TEST(Sizes, RowsFitTheirTable) {
  const auto told = [](const std::string& rows) { return Script("sizes t(a, b = 2cm) {\n" + rows + "\n}\n").told(); };
  EXPECT_THAT(told("  M 1cm"), IsEmpty());
  EXPECT_THAT(told("  M 1cm, 2cm, 3cm"), ElementsAre("E0119 2:3 size `M` has 3 of the 2 measures of `t`"));
  EXPECT_THAT(told("  M 1cm\n  L 3deg"),
              ElementsAre("E0119 3:5 `a` of size `L` is an angle, and of size `M` a length"));
  EXPECT_THAT(told("  M 1cm, 2"), ElementsAre(StartsWith("E0203 2:10 ")));
  EXPECT_THAT(told("  M 1cm\n  M 2cm"), ElementsAre("E0404 3:3 size `M` is given twice"));
  EXPECT_THAT(told("  all 1cm"), ElementsAre(StartsWith("E0119 2:3 no size is called `all`")));
  EXPECT_THAT(told(""), ElementsAre("E0119 1:7 size table `t` has no rows"));
  EXPECT_THAT(told("  M wiast"), ElementsAre(StartsWith("E0101 2:5 ")));
  EXPECT_THAT(Script("sizes t(size) {\n  M 1cm\n}\n").told(), ElementsAre(StartsWith("E0119 1:9 `size` cannot")));
  EXPECT_THAT(Script("sizes t(a, a) {\n  M 1cm, 2cm\n}\n").told(), ElementsAre(StartsWith("E0102 1:12 ")));
}

TEST(Sizes, OfAModuleOnlyTheTablesThatAreUsedFollowTheChoice) {
  const std::string text = "import sizing\nprint sizing.women.waist\n";
  EXPECT_THAT(Sized(text, "8").printed(), ElementsAre("68 cm"));
  EXPECT_EQ(Sized(text, "").program->sizes().size(), 10u);
  EXPECT_THAT(Sized(text, "92").told(), ElementsAre(StartsWith("E0118 ")));
}

}  // namespace
}  // namespace toile::test
