// Pieces as functions, pieces taken from other garments, and records given as arguments.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string band =
    "piece band(around, depth = 4cm) {\n  outline from (0cm, 0cm) {\n    foot  = line to (around, 0cm)\n"
    "    right = line to (around, depth)\n    head  = line to (0cm, depth)\n    left  = line to start\n  }\n}\n";

TEST(FreePieces, AreDrawnByACall) {
  const Script script(band +
                      "garment tube {\n  piece wall = band(60cm, depth: 30cm)\n  piece top = band(length(wall.head))\n"
                      "  sew wall.head to top.foot\n}\nprint length(tube.top.foot)\n");
  ASSERT_THAT(script.told(), IsEmpty());
  ASSERT_EQ(script.program->garments().size(), 1u);
  const Garment& tube = script.program->garments().front();
  ASSERT_EQ(tube.pieces.size(), 2u);
  EXPECT_EQ(tube.pieces[0].name, "wall");
  EXPECT_EQ(tube.pieces[1].name, "top");
  EXPECT_NEAR(tube.pieces[0].edge(1).curve.length(), 0.30, 1e-12);
  EXPECT_NEAR(tube.pieces[1].edge(1).curve.length(), 0.04, 1e-12);
}

TEST(FreePieces, ComeFromModulesAndOtherGarments) {
  const std::string part =
      "import \"parts.toile\"\ngarment g {\n  piece a = parts.band(20cm)\n  piece b = parts.tube.wall\n"
      "  sew a.foot to b.foot\n}\nprint length(g.b.foot)\n";
  Script script(part, {}, {{"parts.toile", band + "garment tube {\n  piece wall = band(20cm)\n}\n"}});
  EXPECT_THAT(script.told(), IsEmpty());
  EXPECT_THAT(script.printed(), ElementsAre("20 cm"));
}

TEST(FreePieces, InAGarmentSeeItsNames) {
  const Script script(
      "garment g {\n  let depth = 5cm\n  piece patch(width) {\n    outline from (0cm, 0cm) {\n"
      "      a = line to (width, 0cm)\n      b = line to (width, depth)\n      c = line to start\n    }\n  }\n"
      "  piece p = patch(6cm)\n}\n");
  EXPECT_THAT(script.told(), IsEmpty());
  EXPECT_EQ(script.program->garments().front().pieces.size(), 1u);
}

TEST(FreePieces, AreVariedWhereTheyAreTaken) {
  // What `band` computes from its parameters is computed anew; `end` around the wall is not the garment's.
  const std::string parts =
      "import \"parts.toile\"\ngarment g {\n  let end = 3cm\n  piece a = parts.band(20cm) with {\n"
      "    let depth = 2 * end\n    label \"{depth}\"\n  }\n  piece b = a with {\n    outline {\n"
      "      foot = line to (20cm + end, 0cm)\n    }\n  }\n  piece c = parts.tube.wall with {\n    cut 3 plies 3\n  }\n"
      "  sew a.head to c.foot\n  sew b.head to c.head ease\n}\n"
      "print length(g.a.right), length(g.b.foot), length(g.c.right)\n";
  Script varied(parts, {}, {{"parts.toile", band + "garment tube {\n  let end = 9cm\n  piece wall = band(20cm)\n}\n"}});
  ASSERT_THAT(varied.told(), IsEmpty());
  EXPECT_THAT(varied.printed(), ElementsAre("6 cm 23 cm 4 cm"));
  EXPECT_EQ(varied.program->garments().back().pieces[0].label, "6 cm");
  EXPECT_EQ(varied.program->garments().back().pieces[2].quantity, 3);
}

TEST(FreePieces, AreVariedAtTheTopOfAFile) {
  Script script(band +
                "piece tall = band(9cm) with {\n  let depth = 12cm\n}\npiece wide(by) = band(by) with {\n"
                "  label \"{by}\"\n}\ngarment g {\n  piece a = tall\n  piece b = wide(12cm)\n"
                "  sew a.right to b.foot\n}\nprint length(tall.right)\n");
  ASSERT_THAT(script.told(), IsEmpty());
  EXPECT_THAT(script.printed(), ElementsAre("12 cm"));
  EXPECT_EQ(script.program->garments().front().pieces[1].label, "12 cm");
}

TEST(FreePieces, DoNotSeeWhatAVariationOnlyHasForItself) {
  // `w` is a let around the model, and another one in the variation.
  const std::string parts =
      "garment g {\n  let w = 10cm\n  piece p {\n    outline from (0cm, 0cm) {\n      a = line to (w, 0cm)\n"
      "      b = line to (w, 5cm)\n      c = line to start\n    }\n  }\n}\n";
  Script script(
      "import \"parts.toile\"\ngarment h {\n  piece q = parts.g.p with {\n    let w = 2cm\n    notch at w of a\n"
      "  }\n}\nprint length(h.q.a), h.q.w\n",
      {}, {{"parts.toile", parts}});
  ASSERT_THAT(script.told(), IsEmpty());
  EXPECT_THAT(script.printed(), ElementsAre("10 cm 2 cm"));
}

TEST(FreePieces, MistakesAreToldWhereTheyAre) {
  EXPECT_THAT(Script(band + "garment g {\n  piece a = band(depth: 3cm)\n}\n").told(),
              ElementsAre(StartsWith("E0108 10:13 `band` needs `around`")));
  EXPECT_THAT(Script(band + "garment g {\n  piece a = band\n}\n").told(),
              ElementsAre(StartsWith("E0108 10:13 piece `band` needs `around`")));
  EXPECT_THAT(Script("garment g {\n  piece a = 3cm\n}\n").told(),
              ElementsAre(StartsWith("E0202 2:13 a piece is wanted here")));
  EXPECT_THAT(
      Script(band + "garment g {\n  piece a = band(9cm)\n  piece b = a with {\n    outline {\n      fot = line to "
                    "(9cm, 0cm)\n    }\n  }\n}\n")
          .told(),
      ElementsAre(StartsWith("E0308 13:7 piece `a` has no edge `fot` to replace")));
  EXPECT_THAT(Script("garment g {\n  piece b = nothing.at_all with {\n  }\n}\n").told(),
              ElementsAre(StartsWith("E0101 2:13")));
  EXPECT_THAT(
      Script("piece p {\n  outline from (0cm, 0cm) {\n    a = line to (wide, 0cm)\n    b = line to start\n  }\n}\n")
          .told(),
      ElementsAre(StartsWith("E0101 3:18")));
}

TEST(RecordsAsArguments, GiveWhatTheCalleeTakes) {
  const std::string text =
      "fn area(width, height = 2cm) = width * height / 1cm\nlet m = (width: 3cm, height: 4cm, colour: 7)";
  EXPECT_EQ(value_of("area(m...)", text), "12 cm");
  EXPECT_EQ(value_of("area(m..., height: 1cm)", text), "3 cm");
  EXPECT_EQ(value_of("area(5cm, m...)", text), "20 cm");
}

TEST(RecordsAsArguments, AreRecordsOfSomeUse) {
  EXPECT_THAT(Script("fn f(a = 1) = a\nlet x = f(3...)\n").told(),
              ElementsAre(StartsWith("E0202 2:11 only a record's")));
  const Script script("fn f(a = 1) = a\nlet x = f((b: 2)...)\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0107 2:11 `f` takes nothing of this record")));
  EXPECT_THAT(script.rendered(), HasSubstr("it takes a"));
}

}  // namespace
}  // namespace toile::test
