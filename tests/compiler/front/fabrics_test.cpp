// Fabrics as KES sheets, textiles as thread counts, bodies by parts.
#include <gmock/gmock.h>

#include "compiler/pattern/fabric_rows.hpp"
#include "compiler/units/unit.hpp"
#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

const std::string square_piece =
    "  piece p {\n    outline from (0cm, 0cm) {\n      a = line to (10cm, 0cm)\n      b = line to (10cm, 10cm)\n"
    "      c = line to (0cm, 10cm)\n      d = line to start\n    }\n  }\n}\n";

TEST(Fabrics, RowsAreConvertedToSi) {
  const Script script(
      "fabric serge {\n  source \"a test\"\n  LT 0.6\n  WT 6.0 gf*cm/cm^2, 9.0 gf*cm/cm^2\n  EMT 4%, 6%\n"
      "  G 0.6 gf/cm/deg\n  2HG 0.7 gf/cm\n  B 0.07 gf*cm^2/cm, 0.06 gf*cm^2/cm\n  2HB 0.025 gf*cm/cm\n"
      "  T0 0.7 mm\n  W 19.2 mg/cm^2\n  MIU 0.18\n}\ngarment g in serge {\n" +
      square_piece);
  ASSERT_THAT(script.told(), IsEmpty());
  const FabricSheet& sheet = script.program->garments().at(0).fabric;
  EXPECT_EQ(sheet.name, "serge");
  EXPECT_EQ(sheet.source, "a test");
  EXPECT_NEAR(sheet.wt->weft, 9 * 0.980665, 1e-12);
  EXPECT_DOUBLE_EQ(sheet.emt->warp, 0.04);
  EXPECT_NEAR(sheet.g->warp, 0.6 * 56.188, 1e-3);
  EXPECT_EQ(sheet.g->warp, sheet.g->weft);
  EXPECT_NEAR(sheet.hg->warp, 0.7 * 0.980665, 1e-12);
  EXPECT_NEAR(sheet.b->weft, 0.06 * 9.80665e-5, 1e-16);
  EXPECT_NEAR(sheet.hb->warp, 0.025 * 9.80665e-3, 1e-14);
  EXPECT_NEAR(*sheet.weight, 0.192, 1e-15);
  EXPECT_NEAR(*sheet.t0, 0.7e-3, 1e-15);
  EXPECT_FALSE(sheet.rt);
}

TEST(Fabrics, WeightAndBendingAreAskedForByName) {
  const Script script("fabric a {\n  G 0.6 gf/cm/deg\n}\n");
  EXPECT_THAT(script.told(),
              testing::UnorderedElementsAre(AllOf(
                  StartsWith("E0401 1:8"), HasSubstr("`a` has no weight (row W) and no bending stiffness (row B)"))));
}

TEST(Fabrics, AVariationKeepsTheOtherRows) {
  const Script script("import fabrics\nfabric heavy = fabrics.denim with {\n  W 60 mg/cm^2\n}\ngarment g in heavy {\n" +
                      square_piece);
  ASSERT_THAT(script.told(), IsEmpty());
  const FabricSheet& sheet = script.program->garments().at(0).fabric;
  EXPECT_DOUBLE_EQ(*sheet.weight, 0.6);
  EXPECT_NEAR(sheet.b->warp, 0.55 * 9.80665e-5, 1e-12);
  EXPECT_EQ(sheet.name, "heavy");
}

TEST(Fabrics, WrongRows) {
  const Script script(
      "fabric a {\n  W 19 mg/cm\n  B -0.1 gf*cm^2/cm\n  EMS 4%\n  T0 1mm\n  T0 2mm\n  MIU 0.2, 0.3, 0.4\n"
      "  EMT 900%\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0201 2:5"), HasSubstr("mg/cm^2")), StartsWith("E0403 3:5"),
                                         AllOf(StartsWith("E0402 4:3"), HasSubstr("`EMS`")), StartsWith("E0404 6:3"),
                                         StartsWith("E0403 7:12"), StartsWith("E0403 8:7")));
  EXPECT_THAT(script.rendered(), AllOf(HasSubstr("did you mean `EMT`?"), HasSubstr("this is negative")));
}

TEST(Fabrics, OnePropertyIsMeasuredByOneInstrument) {
  EXPECT_THAT(
      Script("fabric a {\n  C 18mm\n  2HB 0.02 gf*cm/cm\n  EB5 3%\n  W 19 mg/cm^2\n}\n").told(),
      ElementsAre(AllOf(StartsWith("E0413 2:3"), HasSubstr("bending of fabric `a`"), HasSubstr("`2HB` and `C`"))));
  EXPECT_THAT(Script("fabric a {\n  C 18mm\n  C45 17mm\n  twist 0.02 gf*cm^2/cm\n  W 19 mg/cm^2\n}\n").told(),
              ElementsAre(AllOf(StartsWith("E0413 3:3"), HasSubstr("twisting"))));
}

TEST(Fabrics, TheOtherInstrumentReplacesWhatAVariationHas) {
  const Script script(
      "import fabrics\nfabric a = fabrics.denim with {\n  C 20mm, 15mm\n}\nfabric b = a with {\n  B 0.2 gf*cm^2/cm\n}\n"
      "garment g in a {\n" +
      square_piece + "garment h in b {\n" + square_piece);
  ASSERT_THAT(script.told(), IsEmpty());
  const FabricSheet& a = script.program->garments().at(0).fabric;
  EXPECT_FALSE(a.b || a.hb);
  EXPECT_DOUBLE_EQ(a.c->weft, 0.015);
  EXPECT_TRUE(a.emt);
  const FabricSheet& b = script.program->garments().at(1).fabric;
  EXPECT_FALSE(b.c);
  EXPECT_NEAR(b.b->warp, 0.2 * 9.80665e-5, 1e-16);
}

TEST(Fabrics, MeasurementsThatNoClothHasTogether) {
  const auto told = [](const std::string& rows) {
    return Script("fabric a {\n  W 19 mg/cm^2\n" + rows + "}\n").told();
  };
  EXPECT_THAT(told("  C 18mm\n  E20 2%\n  E100 1%\n"),
              ElementsAre(AllOf(StartsWith("E0414 4:3"), HasSubstr("2% at 20 gf/cm and 1% at 100"))));
  EXPECT_THAT(told("  C 18mm\n  E20 1%\n  E100 5.1%\n"),
              ElementsAre(AllOf(StartsWith("E0414 5:3"), HasSubstr("softer"))));
  EXPECT_THAT(told("  C 18mm\n  E100 5%\n"), ElementsAre(StartsWith("E0414 4:3")));
  EXPECT_THAT(told("  B 0.1 gf*cm^2/cm\n  B45 0.2 gf*cm^2/cm\n"),
              ElementsAre(AllOf(StartsWith("E0414 4:3"), HasSubstr("below 0.2 gf*cm^2/cm"))));
  EXPECT_THAT(told("  C 18mm\n  C45 24mm\n"), ElementsAre(AllOf(StartsWith("E0414 4:3"), HasSubstr("below 22.68 mm"))));
  EXPECT_THAT(told("  C45 24mm\n  B 0.1 gf*cm^2/cm\n"), ElementsAre(StartsWith("E0413")));
}

TEST(Fabrics, TensileRowsThatContradictEachOtherAreAWarning) {
  const Script script("fabric a {\n  LT 0.6\n  EMT 4%\n  WT 7 gf*cm/cm^2\n  W 19 mg/cm^2\n  B 0.1 gf*cm^2/cm\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("W0405 4:3"), HasSubstr("LT * Fm * EMT / 2 is 6"))));
  EXPECT_TRUE(script.program->ok());
}

TEST(Fabrics, OtherRowsThatContradictEachOtherAreWarningsToo) {
  const std::string rest = "  W 19 mg/cm^2\n  B 0.1 gf*cm^2/cm\n}\n";
  EXPECT_THAT(Script("fabric a {\n  G 0.6 gf/cm/deg\n  2HG 1.5 gf/cm\n  2HG5 0.7 gf/cm\n" + rest).told(),
              ElementsAre(AllOf(StartsWith("W0412 4:3"), HasSubstr("narrower at 5 deg"))));
  EXPECT_THAT(Script("fabric a {\n  G 0.6 gf/cm/deg\n  2HG 1.5 gf/cm\n  2HG5 15 gf/cm\n" + rest).told(),
              ElementsAre(AllOf(StartsWith("W0412 2:3"), HasSubstr("grows faster than its curve"))));
  EXPECT_THAT(Script("fabric a {\n  T0 0.3 mm\n  Tm 0.5 mm\n" + rest).told(),
              ElementsAre(AllOf(StartsWith("W0412 3:3"), HasSubstr("thicker under"))));
  EXPECT_THAT(Script("fabric a {\n  G 0.6 gf/cm/deg\n  2HG 0.7 gf/cm\n  2HG5 1.5 gf/cm\n" + rest).told(), IsEmpty());
}

TEST(Textiles, ThreadsBecomeStripes) {
  const Script script("textile t {\n  thread 0.5mm\n  warp 8, #1f3a5f, 2, #ffffff\n}\ngarment g printed t {\n" +
                      square_piece);
  ASSERT_THAT(script.told(), IsEmpty());
  const Textile& textile = script.program->garments().at(0).textile;
  ASSERT_THAT(textile.warp, SizeIs(2));
  EXPECT_DOUBLE_EQ(textile.warp[0].width, 4e-3);
  EXPECT_EQ(textile.warp[1].colour, (Colour{255, 255, 255}));
  ASSERT_THAT(textile.weft, SizeIs(1));
  EXPECT_EQ(textile.weft[0].colour, (Colour{0x1f, 0x3a, 0x5f}));
}

TEST(Textiles, WrongRows) {
  const Script script("textile t {\n  warp 8, #1f3a5f, 2\n  weft 3, 4cm\n  wrap 1, #fff\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0406 2:20"), StartsWith("E0406 3:11"), StartsWith("E0402 4:3")));
}

TEST(Bodies, SectionsAndLimbsAreRead) {
  const Script script(
      "body form {\n  let w = 68cm\n  section hip at 80cm { girth 94cm, ratio 1.4 }\n"
      "  section waist at 104cm { girth w, forward 1cm\n squareness 2.1 }\n"
      "  limb leg { root 54cm, tip 24cm, length 60cm, angle 4deg }\n  surface { softness 2e5 N/m^3, friction 0.3 "
      "}\n}\n");
  ASSERT_THAT(script.told(), IsEmpty());
  const BodySpec& body = script.program->bodies().at(0);
  const auto& form = std::get<FormSpec>(body.shape);
  ASSERT_THAT(form.sections, SizeIs(2));
  EXPECT_EQ(form.sections[1].name, "waist");
  EXPECT_DOUBLE_EQ(form.sections[1].girth, 0.68);
  EXPECT_DOUBLE_EQ(form.sections[1].forward, 0.01);
  ASSERT_THAT(form.limbs, SizeIs(1));
  EXPECT_EQ(form.limbs[0].kind, BodyLimb::Kind::Leg);
  EXPECT_DOUBLE_EQ(body.softness, 2e5);
  EXPECT_DOUBLE_EQ(*body.friction, 0.3);
}

TEST(Bodies, PrimitivesAndMeshes) {
  const Script script(
      "body ball = sphere(radius: 15cm, height: 60cm, friction: 0.4)\n"
      "body bar = cylinder(radius: 2cm, length: 1m, upright: false)\n"
      "body figure = mesh(\"figure.obj\") with {\n  line waist { through (0cm, 0cm, 105cm), normal (0, 0, 2) }\n}\n"
      "body missing = mesh(\"missing.obj\")\n"
      "body flat = sphere(radius: -1cm)\n"
      "let girth = figure.waist.girth\nlet level = figure.wiast.level\n");
  EXPECT_THAT(script.told(),
              ElementsAre(AllOf(StartsWith("E0407 6:1"), HasSubstr("cannot be read")), StartsWith("E0208 7:28"),
                          AllOf(StartsWith("E0103 9:20"), HasSubstr("no line `wiast`"))));
  const auto& bodies = script.program->bodies();
  EXPECT_EQ(bodies.at(0).name, "ball");
  EXPECT_DOUBLE_EQ(std::get<SphereSpec>(bodies.at(0).shape).radius, 0.15);
  EXPECT_FALSE(std::get<CylinderSpec>(bodies.at(1).shape).upright);
  EXPECT_DOUBLE_EQ(std::get<MeshSpec>(bodies.at(2).shape).lines.at(0).nz, 1);
}

TEST(Bodies, IncompleteParts) {
  const Script script(
      "body form {\n  section hip at 80cm { girht 94cm }\n  section waist { girth 68cm }\n  limb tail { root 3cm "
      "}\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0408 2:3"), StartsWith("E0103 2:25"), StartsWith("E0408 3:3"),
                                         StartsWith("E0408 4:8")));
}

TEST(StandardLibrary, EveryFabricPrintAndBodyIsSound) {
  for (const Module& module : stdlib_modules()) {
    Script script("import \"whole.toile\"\n", {}, {{"whole.toile", std::string(module.text)}});
    EXPECT_THAT(script.told(), IsEmpty()) << module.name << "\n" << script.rendered();
  }
}

TEST(FabricRows, HaveTheSizesOfTheirUnits) {
  for (const FabricRow& row : fabric_rows()) {
    if (row.unit == "1") continue;
    EXPECT_NEAR(row.size, parse_unit(row.unit)->factor, 1e-12 * row.size) << row.name;
  }
}

}  // namespace
}  // namespace toile::test
